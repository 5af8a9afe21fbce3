"""``$(…)``: what is replaced, what stays, and what is refused."""

from __future__ import annotations

from tests.evaluate.comparison import case

PACKAGES = {
    "ws/p/package.xml": "<package><name>p</name></package>",
    "ws/q r/package.xml": "<package><name>q</name></package>",
    "ws/p/launch/a.launch": "[[a]]",
    "ws/p/meta/package.xml": "<package><name>inside</name></package>",
}


def values(*texts: str, before: str = "", refused: tuple[str, ...] = (), **more: dict[str, str]):  # type: ignore[no-untyped-def]
    """Params that hold these values."""
    params = "".join(f'<param name="p{number}" value="{text}"/>' for number, text in enumerate(texts))
    more.setdefault("files", PACKAGES)
    return case(before + params, *refused, **more)  # type: ignore[arg-type]


A = '<arg name="a" value="1"/><arg name="b" value="x y"/><arg name="c" value=""/>'

SUBSTITUTIONS = {
    "args in text": values("$(arg a)", "x$(arg a)y$(arg b)", "$( arg  a )", "$(arg a)$(arg a)", "$(arg c)", before=A),
    "what stays as it is": values("$(arg a", "${arg a}", "$ (arg a)", "$()", "$", "$$", "(arg a)", "$a", "arg a)", ")", "$)", before=A),
    "two dollars": values("$$(arg a)", "$x$(arg a)", "$ $(arg a)", before=A),
    "a parenthesis after one": values("$(arg a))", "($(arg a))", "(x)$(arg a)", before=A),
    "one inside another": values("$(arg $(arg a))", before=A, refused=("bad-substitution",)),
    "a dollar inside": values("$(arg a$)", before=A, refused=("bad-substitution",)),
    "a parenthesis inside": values("$(arg (a))", before=A, refused=("bad-substitution",)),
    "an open one, then another": values("$(arg a $(arg a)", before=A, refused=("bad-substitution",)),
    "two parentheses, and no more": values("$((", refused=("bad-substitution",)),
    "two parentheses": values("$((arg a))", refused=("bad-substitution",)),
    "an open one, then a parenthesis": values("$(", "$(arg", "$(arg a"),
    "an unknown command": values("$(args a)", refused=("bad-substitution",)),
    "a command in capital letters": values("$(ARG a)", before=A, refused=("bad-substitution",)),
    "a blank only": values("$( )", refused=("bad-substitution",)),
    "an arg without a name": values("$(arg)", refused=("bad-substitution",)),
    "an arg with two names": values("$(arg a b)", before=A, refused=("bad-substitution",)),
    "a tab is no blank": values("$(arg&#9;a)", before=A, refused=("bad-substitution",)),
    "an unknown command that is switched off": case('<param name="x" value="$(bad)" if="0"/>[[n]]'),
    "args that hold substitutions": values(
        "$(arg d)",
        "$(arg e)(arg f)",
        "$(arg f)",
        before='<arg name="d" value="$(optenv"/><arg name="e" value="$"/><arg name="f" value="a)"/>',
    ),
    "a find that comes out of an arg": values("$(arg d)p)/x", before='<arg name="d" value="$(find "/>'),
    "an unknown command that comes out of an arg": values(
        "$(arg d)(bad)", before='<arg name="d" value="$"/>', refused=("bad-substitution",)
    ),
    "an arg that comes out of an arg": values("$(arg d)(arg a)", before=A + '<arg name="d" value="$"/>'),
    # env
    "env": values("$(env A)", "x$(env A)y", environment={"A": "1"}),
    "env that is not set": values("$(env NO)", refused=("env-unset",)),
    "env that is empty": values("$(env A)", environment={"A": ""}),
    "env with two names": values("$(env A B)", refused=("bad-substitution",), environment={"A": "1"}),
    "env without a name": values("$(env)", refused=("bad-substitution",)),
    "optenv": values("$(optenv A)", "$(optenv NO)", "$(optenv NO x)", "$(optenv NO  x   y )", "[$(optenv A x)]", environment={"A": "1"}),
    "optenv without a name": values("$(optenv)", refused=("bad-substitution",)),
    "env that holds a find": values("$(env A)", environment={"A": "$(find p)"}),
    "env that holds an arg": values("$(env A)", before=A, environment={"A": "$(arg a)"}),
    "env that holds an unknown command": values("$(env A)", environment={"A": "$(bad)"}, refused=("bad-substitution",)),
    "env that holds an eval": values("$(env A)", environment={"A": "$(eval 1)"}, refused=("bad-substitution",)),
    # find
    "find": values("$(find p)", "$(find p)/x", "$(find p)x", "$(find p)/", "$(find p)/x y", "$( find  p )/x", "$(find p)\\x\\y"),
    "find in the middle": values(
        "a:$(find p)/x:b", "--x=$(find p)/y --z", "$(find p)/a:$(find q)/b", "$(find p) $(find q)", "$(find p)/a $(find p)/b"
    ),
    "find with args in the path": values("$(find p)/$(arg a)/$(arg b)", "$(find $(optenv NO p))", before=A, refused=("bad-substitution",)),
    "find with an arg behind it": values("$(find p)/$(arg a)/$(arg b)/z", before=A),
    "find with an absolute path": values("$(find p)//etc/x", "$(find p)///x"),
    "find with dots": values("$(find p)/../q r/x", "$(find p)/./x"),
    "find of a package that is not here": values("$(find nothing)/x", refused=("package-not-found",)),
    "find of a package inside another": values("$(find inside)", refused=("package-not-found",)),
    "find without a name": values("$(find)", refused=("bad-substitution",)),
    "find with two names": values("$(find p q)", refused=("bad-substitution",)),
    "find in an include": case('<include file="$(find p)/launch/a.launch"/>', files=PACKAGES),
    "find in an include without a slash": case('<include file="$(find p)launch/a.launch"/>', files=PACKAGES),
    # dirname
    "dirname": values("$(dirname)", "$(dirname)/..", "$(dirname x)"),
    "dirname of a relative include": case(
        '<include file="d/i.launch"/>',
        files={
            "d/i.launch": '<param name="x" value="$(dirname)"/><include file="d/../d/j.launch"/>',
            "d/j.launch": '<param name="y" value="$(dirname)"/>',
        },
    ),
    # anon
    "one anonymous name": case('[[$(anon a)]]<param name="x" value="$(anon a) $(anon a)"/>'),
    "characters of anonymous names": case('<param name="x" value="$(anon a.b-c:d)"/>'),
    "anonymous names of siblings": case("<group>[[$(anon a)]]</group><group>[[$(anon a)]]</group>[[$(anon a)]]"),
    "anonymous names go into groups": case('<param name="x" value="$(anon a)"/><group><param name="y" value="$(anon a)"/></group>'),
    "anonymous names and includes": case(
        '<param name="x" value="$(anon a)"/><include file="$(dirname)/i.launch">'
        '<arg name="v" value="$(anon a) $(anon b)"/></include><param name="z" value="$(anon b)"/>',
        files={"i.launch": '<arg name="v"/><param name="y" value="$(anon a) $(anon b) $(arg v)"/>'},
    ),
    "anonymous names in a file that is included twice": case(
        '<include file="$(dirname)/i.launch"/><include file="$(dirname)/i.launch"/>', files={"i.launch": "[[$(anon a)]]"}
    ),
    "anonymous names in a node": case(
        '[[$(anon n) args="$(anon a)" | <param name="x" value="$(anon n) $(anon a)"/>'
        '<remap from="q" to="$(anon r)"/><env name="A" value="$(anon e)"/>]]'
        '<param name="y" value="$(anon n) $(anon a) $(anon x) $(anon r) $(anon e)"/>'
    ),
    "anonymous names in the env of two nodes": case(
        '[[n | <env name="A" value="$(anon e)"/>'
        '<env name="B" value="$(anon e)"/>]][[m | <env name="A" value="$(anon e)"/>]]<env name="C" value="$(anon e)"/>[[o]]'
    ),
    "anonymous names in the params of a node": case(
        '[[n | <param name="x" value="$(anon e)"/><param name="y" value="$(anon e)"/>]][[m | <param name="x" value="$(anon e)"/>]]'
    ),
    "anonymous names in a rosparam of a node": case(
        '[[n | <rosparam subst_value="true">{a: $(anon e)}</rosparam><param name="y" value="$(anon e)"/>]]'
    ),
    "anonymous names in conditions": case(
        '<group if="$(eval anon(\'a\') != \'\')"><param name="x" value="$(anon a)"/></group><param name="y" value="$(anon a)"/>'
    ),
    "anonymous names in a machine": case(
        '<machine name="$(anon m)" address="$(anon h)" user="$(anon u)"/><param name="x" value="$(anon h)"/>'
    ),
    "anonymous names of attributes in turn": case('[[$(anon a) ns="$(anon b)" args="$(anon c)" launch-prefix="$(anon d)"]]'),
    "anonymous names of a test in turn": case('<test test-name="$(anon b)" name="$(anon a)" pkg="$(anon c)" type="$(anon d)" cwd="node"/>'),
    "anonymous names of a param in turn": case(
        '<param name="$(anon a)" value="$(anon b)"/><rosparam param="$(anon d)" ns="$(anon c)">1</rosparam>'
    ),
    "anonymous names of a machine in turn": case(
        '<machine timeout="5" user="$(anon c)" password="x" env-loader="$(anon d)" address="$(anon b)" name="$(anon a)"/>'
    ),
    "anonymous names of an include in turn": case('<include ns="$(anon b)" file="$(dirname)/$(arg f)"/>', "undeclared-arg"),
    "anon without a name": values("$(anon)", refused=("bad-substitution",)),
    "anon with two names": values("$(anon a b)", refused=("bad-substitution",)),
    # eval
    "eval": values("$(eval 1 + 1)", "$(eval a + 1)", "$(eval b + 'z')", "$(eval arg('a'))", "$(eval a == 1)", "$(eval not c)", before=A),
    "eval with env and find": values("$(eval env('A') + optenv('NO', 'x') + find('p'))", environment={"A": "1"}),
    "eval with dirname": values("$(eval dirname() + '/x')"),
    "eval with anon": case('<param name="x" value="$(eval anon(\'a\') + anon(\'a\'))"/><param name="y" value="$(anon a)"/>'),
    "eval not alone": values("x$(eval 1)", refused=("bad-substitution",)),
    "eval with something behind it": values("$(eval 1)x", refused=("bad-substitution",)),
    "eval with a blank behind it": values("$(eval 1) ", refused=("bad-substitution",)),
    "eval with a tab": values("$(eval&#9;1)", refused=("bad-substitution",)),
    "eval of nothing": values("$(eval )", refused=("eval-error",)),
    "eval with an error": values("$(eval 1 +)", refused=("eval-error",)),
    "eval with an unknown name": values("$(eval nothing)", refused=("undeclared-arg",)),
    "eval with an unknown arg": values("$(eval arg('nothing'))", refused=("undeclared-arg",)),
    "eval with underscores": values("$(eval '__')", refused=("eval-error",)),
    "eval with an env that is not set": values("$(eval env('NO'))", refused=("env-unset",)),
    "eval with a package that is not here": values("$(eval find('nothing'))", refused=("package-not-found",)),
    "eval of an arg with the name of a constant": values(
        "$(eval e)", "$(eval pi &gt; 3)", before='<arg name="e" value="5"/><arg name="pi" value="1"/>'
    ),
    "eval of types": values("$(eval str(a) + str(f) + str(t))", before=A + '<arg name="f" value="1.50"/><arg name="t" value="TRUE"/>'),
    "eval in a condition, as a text": case("<group if=\"$(eval 'tr' + 'ue')\">[[n]]</group>"),
    "eval gives a number as a condition": case('<group if="$(eval 2)">[[n]]</group>', "condition-not-boolean"),
    # places
    "where substitutions are not looked at": case(
        '<launch deprecated="$(bad)"><param name="x" type="auto" value="1"/>[[n nonsense="$(bad)"]]</launch>'
    ),
    "in the attribute of a switched-off node": case('[[n if="false" args="$(bad)"]]'),
    "in an arg's default that is not used": case('<arg name="a" default="$(env NO)"/>', "env-unset", args={"a": "1"}),
    "a package in an arg": case('<arg name="a" default="$(find nothing)"/>', "package-not-found"),
    "a package in an arg that is overridden": case('<arg name="a" default="$(find nothing)"/>', "package-not-found", args={"a": "1"}),
}
