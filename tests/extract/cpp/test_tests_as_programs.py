"""Unit tests are programs, too: what gtest, Catch and Boost.Test call is followed like ``main()``."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.extract.cpp.following import lines, program, spelled

MAIN = """
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "t");
  return RUN_ALL_TESTS();
}
"""
KINDS = {
    "functions": (
        """
        TEST(Suite, one) { ros::NodeHandle nh; auto p = nh.advertise<std_msgs::String>("one", 1); }
        TEST(Suite, two)
        { ros::NodeHandle nh("~"); auto p = nh.advertise<std_msgs::String>("two", 1); }
        """,
        "publishers one std_msgs/String 2 queue=1\npublishers ~two std_msgs/String 4 queue=1",
    ),
    "fixtures": (
        """
        class Fixture : public ::testing::Test {
          void SetUp() override { pub_ = nh_.advertise<std_msgs::String>("set_up", 1); }
          ros::NodeHandle nh_;
          ros::Publisher pub_;
          ros::Subscriber sub_;
        };
        TEST_F(Fixture, three) { sub_ = nh_.subscribe<std_msgs::String>("three", 1, heard); }
        """,
        "publishers set_up std_msgs/String 3 queue=1\nsubscribers three std_msgs/String 8 queue=1",
    ),
    "names that are strings": (
        """
        TEST_CASE("what is \\"said\\"",
                  "[first][second]") {
          ros::NodeHandle nh;
          SECTION("of it") { auto p = nh.advertise<std_msgs::String>("four", 1); }
        }
        """,
        "publishers four std_msgs/String 5 queue=1",
    ),
    "those that are left out": (
        """
        TEST(S, DISABLED_six) { ros::NodeHandle nh; auto p = nh.advertise<std_msgs::String>("six", 1); }
        TEST(S, seven) { ros::NodeHandle nh; auto p = nh.advertise<std_msgs::String>("seven", 1); }
        """,
        "publishers seven std_msgs/String 3 queue=1",
    ),
    "Boost": (
        'BOOST_AUTO_TEST_CASE(five) { ros::NodeHandle nh; auto p = nh.advertise<std_msgs::String>("five", 1); }',
        "publishers five std_msgs/String 1 queue=1",
    ),
}


@pytest.mark.parametrize("main", ["", MAIN])
@pytest.mark.parametrize("name", KINDS)
def test_what_a_test_does_is_followed_and_leaves_nothing_open(tmp_path: Path, name: str, main: str) -> None:
    source, expected = KINDS[name]
    facts, doubts = program(tmp_path, source + main)
    assert [spelled(each) for each in facts] == lines(expected)
    assert not doubts


def test_a_program_without_a_start_is_still_told(tmp_path: Path) -> None:
    _, doubts = program(tmp_path, "void helper() { }")
    assert {each.reason for each in doubts} == {"no main() was found in these sources"}
