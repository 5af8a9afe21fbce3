"""What is made of texts is kept by the text, within a bound."""

from __future__ import annotations

from launchlint.evaluate.by_text import ByText


def test_what_is_kept_is_not_made_again_and_what_was_asked_for_longest_ago_goes_first() -> None:
    made: list[str] = []

    def ask(kept: ByText, text: str, key: str = "length") -> int:
        def make() -> int:
            made.append(f"{key} {text}")
            return len(text)

        return kept.once(text, key, make)

    kept = ByText(most=10)
    assert [ask(kept, "aaaa"), ask(kept, "bbbb"), ask(kept, "aaaa")] == [4, 4, 4]
    assert made == ["length aaaa", "length bbbb"]
    ask(kept, "cccc")
    assert len(kept) == 2
    ask(kept, "aaaa")
    assert made == ["length aaaa", "length bbbb", "length cccc"]
    ask(kept, "bbbb")
    assert made[3:] == ["length bbbb"]
    ask(kept, "bb", "other")
    assert made[4:] == ["other bb"]
    assert ask(kept, "d" * 11) == 11
    assert len(kept) == 0, "a text that is longer than all may be is not kept, and nothing beside it"
