"""Args: declarations, scopes, the command line, includes and ``pass_all_args``; conditions."""

from __future__ import annotations

from tests.evaluate.comparison import case

GO = '<include file="$(dirname)/inner.launch"/>'
SHOW = '<param name="x" value="$(arg a)"/>'


def passing(inner: str, children: str = "", attributes: str = "", before: str = "", after: str = "", *refused: str, **more: dict[str, str]):  # type: ignore[no-untyped-def]
    """A file that includes one other, with what stands before, in and after the include."""
    main = f'{before}<include file="$(dirname)/inner.launch" {attributes}>{children}</include>{after}'
    return case(main, *refused, files={"inner.launch": inner}, **more)  # type: ignore[arg-type]


ALL = 'pass_all_args="true"'

ARGUMENTS = {
    # declarations
    "a default": case('<arg name="a" default="1"/>' + SHOW),
    "a default is overridden": case('<arg name="a" default="1"/>' + SHOW, args={"a": "2"}),
    "a value": case('<arg name="a" value="1"/>' + SHOW),
    "a value cannot be overridden": case('<arg name="a" value="1"/>', "arg-override-refused", args={"a": "2"}),
    "a required arg that is given": case('<arg name="a"/>' + SHOW, args={"a": "2"}),
    "a required arg that is not given": case('<arg name="a"/>' + SHOW, "required-arg-unset"),
    "a required arg that nobody reads": case('<arg name="a"/>'),
    "value and default": case('<arg name="a" value="" default=""/>', "arg-value-and-default"),
    "an arg without a name": case('<arg value="1"/>', "missing-attribute"),
    "an arg with an empty name": case('<arg name="" value="1"/><param name="x" value="$(eval 1)"/>'),
    "an unknown attribute of an arg": case('<arg name="a" description="x" default="1"/>' + SHOW),
    "doc is resolved": case('<arg name="a" default="1" doc="$(arg nothing)"/>', "undeclared-arg"),
    "an arg named by an arg": case('<arg name="a" value="b"/><arg name="$(arg a)" value="1"/><param name="x" value="$(arg b)"/>'),
    "the same arg twice": case('<arg name="a" default="1"/><arg name="a" default="2"/>', "arg-redeclared"),
    "the same arg twice, once under a false condition": case('<arg name="a" value="1" if="0"/><arg name="a" value="2" unless="0"/>' + SHOW),
    "an arg read before its declaration": case(SHOW + '<arg name="a" value="1"/>', "used-before-declaration"),
    "an arg read before its declaration, given": case(SHOW + '<arg name="a" default="1"/>', args={"a": "2"}),
    "an arg declared nowhere": case(SHOW, "undeclared-arg"),
    "an arg declared nowhere but given": case(SHOW, args={"a": "2"}),
    "given args that nobody declares": case("[[n]]", args={"zz": "2"}),
    "an empty value on the command line": case('<arg name="a" default="1"/>' + SHOW, args={"a": ""}),
    "a blank value on the command line": case('<arg name="a" default="1"/>' + SHOW, args={"a": "  "}),
    "blanks around a value on the command line": case('<arg name="a" default="1"/>' + SHOW, args={"a": " 2 "}),
    "a private name on the command line": case('<arg name="_a" default="1"/><param name="x" value="$(arg _a)"/>', args={"_a": "2"}),
    "a name with two underscores on the command line": case(
        '<arg name="__a" default="1"/><param name="x" value="$(arg __a)"/>', args={"__a": "2"}
    ),
    "a name with a digit first on the command line": case(
        '<arg name="1a" default="1"/><param name="x" value="$(arg 1a)"/>', args={"1a": "2"}
    ),
    "a name with a hyphen on the command line": case(
        '<arg name="a-b" default="1"/><param name="x" value="$(arg a-b)"/>', args={"a-b": "2"}
    ),
    "a value with := on the command line": case('<arg name="a" default="1"/>' + SHOW, args={"a": "b:=c"}),
    "a value with a line end on the command line": case('<arg name="a" default="1"/>' + SHOW, args={"a": "b\nc"}),
    "a substitution on the command line": case('<arg name="a" default="1"/>' + SHOW, args={"a": "$(arg b)"}),
    "a find on the command line": case(
        '<arg name="a" default="1"/>' + SHOW, args={"a": "$(find p)/x"}, files={"p/package.xml": "<package><name>p</name></package>"}
    ),
    # scopes
    "a group sees the args around it": case('<arg name="a" value="1"/><group>' + SHOW + "</group>"),
    "an arg of a group stays there": case('<group><arg name="a" value="1"/></group>' + SHOW, "arg-out-of-scope"),
    "a group cannot declare an outer arg again": case(
        '<arg name="a" value="1"/><group><arg name="a" value="2"/></group>', "arg-redeclared"
    ),
    "a group cannot declare an outer required arg again": case('<arg name="a"/><group><arg name="a" value="2"/></group>', "arg-redeclared"),
    "sibling groups may declare the same arg": case(
        f'<group ns="g"><arg name="a" value="1"/>{SHOW}</group><group ns="h"><arg name="a" value="2"/>{SHOW}</group>'
    ),
    "an arg declared outside after a group": case(f'<group ns="g"><arg name="a" value="1"/>{SHOW}</group><arg name="a" value="2"/>{SHOW}'),
    "a group's arg given on the command line": case(f'<group ns="g"><arg name="a" default="1"/>{SHOW}</group>', args={"a": "2"}),
    "a group's value given on the command line": case('<group><arg name="a" value="1"/></group>', "arg-override-refused", args={"a": "2"}),
    "a group's own arg in a group in it": case(f'<group><arg name="a" default="1"/><group>{SHOW}</group></group>'),
    # includes
    "an arg is passed": passing('<arg name="a"/>' + SHOW, '<arg name="a" value="5"/>'),
    "an arg is passed with default=": passing('<arg name="a"/>' + SHOW, '<arg name="a" default="5"/>'),
    "an arg is passed with both": passing('<arg name="a"/>', '<arg name="a" value="1" default="5"/>', "", "", "", "arg-value-and-default"),
    "an arg is passed without a value": passing('<arg name="a"/>', '<arg name="a"/>', "", "", "", "missing-attribute"),
    "an arg is passed without a name": passing('<arg name="a" default="1"/>', '<arg value="1"/>', "", "", "", "missing-attribute"),
    "an arg is passed empty": passing('<arg name="a" default="1"/>' + SHOW, '<arg name="a" value=""/>'),
    "an arg is passed twice": passing(
        '<arg name="a"/>', '<arg name="a" value="1"/><arg name="a" value="2"/>', "", "", "", "arg-redeclared"
    ),
    "an arg is passed twice, once under a false condition": passing(
        '<arg name="a"/>' + SHOW, '<arg name="a" value="1" if="0"/><arg name="a" value="2" if="1"/>'
    ),
    "an arg is not declared there": passing("", '<arg name="a" value="1"/>', "", "", "", "include-undeclared-arg"),
    "an arg is declared in a group there": passing(
        '<group><arg name="a" default="1"/></group>', '<arg name="a" value="1"/>', "", "", "", "include-undeclared-arg"
    ),
    "an arg is declared under a false condition there": passing(
        '<arg name="a" default="1" if="0"/>', '<arg name="a" value="1"/>', "", "", "", "include-undeclared-arg"
    ),
    "an arg is fixed there": passing('<arg name="a" value="1"/>', '<arg name="a" value="1"/>', "", "", "", "arg-override-refused"),
    "a required arg is not passed": passing('<arg name="a"/>' + SHOW, "", "", '<arg name="a" value="1"/>', "", "include-missing-arg"),
    "a required arg is not passed, nobody reads it": passing('<arg name="a"/>'),
    "the args of the including file are not seen": passing(SHOW, "", "", '<arg name="a" value="1"/>', "", "undeclared-arg"),
    "given args are not seen in includes": passing('<arg name="a" default="1"/>' + SHOW, args={"a": "9"}),
    "passed args are evaluated here": passing(
        '<arg name="a"/><arg name="b" default="there"/>' + SHOW, '<arg name="a" value="$(arg b)"/>', "", '<arg name="b" value="here"/>'
    ),
    "passed args do not see each other": passing(
        '<arg name="a"/><arg name="b"/>', '<arg name="b" value="1"/><arg name="a" value="$(arg b)"/>', "", "", "", "undeclared-arg"
    ),
    "$(dirname) of a passed arg is that of this file": case(
        '<include file="$(dirname)/d/inner.launch"><arg name="a" value="$(dirname)"/></include>',
        files={"d/inner.launch": '<arg name="a"/><param name="x" value="$(arg a) $(dirname)"/>'},
    ),
    "an include's if sees this file": passing(
        '<arg name="a"/>' + SHOW, '<arg name="a" value="1"/>', 'if="$(arg b)"', '<arg name="b" value="1"/>'
    ),
    "tags of an include in capital letters": passing('<arg name="a"/>' + SHOW, '<ARG name="a" value="1"/><Env name="A" value="1"/>'),
    "other tags in an include": passing("[[n]]", '<param name="x" value="1"/><remap/>text'),
    # pass_all_args
    "pass_all_args passes all": passing('<arg name="a"/>' + SHOW, "", ALL, '<arg name="a" default="1"/>'),
    "pass_all_args passes what was given": passing('<arg name="a"/>' + SHOW, "", ALL, args={"a": "7"}),
    "pass_all_args and an own arg": passing('<arg name="a"/>' + SHOW, '<arg name="a" value="2"/>', ALL, '<arg name="a" default="1"/>'),
    "pass_all_args and an own default": passing(
        '<arg name="a"/>' + SHOW, '<arg name="a" default="2"/>', ALL, '<arg name="a" default="1"/>'
    ),
    "pass_all_args and a new default": passing('<arg name="a"/>' + SHOW, '<arg name="a" default="2"/>', ALL),
    "pass_all_args and an own arg without a value": passing(
        '<arg name="a"/>' + SHOW, '<arg name="a"/>', ALL, '<arg name="a" default="1"/>'
    ),
    "pass_all_args and a new arg without a value": passing('<arg name="a"/>', '<arg name="a"/>', ALL, "", "", "missing-attribute"),
    "pass_all_args and an own arg twice": passing('<arg name="a"/>' + SHOW, '<arg name="a" value="1"/><arg name="a" value="2"/>', ALL),
    "pass_all_args checks no undeclared ones": passing("", '<arg name="typo" value="1"/>', ALL),
    "pass_all_args checks no undeclared ones, but names": passing(
        '<node pkg="p" type="t" name="a"/><node pkg="p" type="t" name="a"/>', '<arg name="typo" value="1"/>', ALL, "", "", "duplicate-node"
    ),
    "pass_all_args and a value there": passing(
        '<arg name="a" value="3"/>' + SHOW, '<arg name="a" value="2"/>', ALL, '<arg name="a" default="1"/>'
    ),
    "pass_all_args and a value in a group there": passing(
        '<group><arg name="a" value="3"/></group>', "", ALL, '<arg name="a" default="1"/>', "", "arg-override-refused"
    ),
    "pass_all_args and a default in a group there": passing(
        f'<group><arg name="a" default="3"/>{SHOW}</group>', "", ALL, '<arg name="a" default="1"/>'
    ),
    "pass_all_args and an arg declared twice there": passing('<arg name="a" default="1"/><arg name="a" value="2"/>' + SHOW, "", ALL),
    "pass_all_args and an arg declared again in a group there": passing(
        '<arg name="a" default="1"/><group><arg name="a" default="2"/></group>', "", ALL, "", "", "arg-redeclared"
    ),
    "pass_all_args does not pass to the next include": passing(
        '<include file="$(dirname)/main2.launch"/>', "", ALL, '<arg name="a" default="1"/>', "", "include-not-found"
    ),
    "pass_all_args twice": case(
        f'<arg name="a" default="1"/><include file="$(dirname)/b.launch" {ALL}/>',
        files={"b.launch": f'<include file="$(dirname)/c.launch" {ALL}/>', "c.launch": SHOW},
    ),
    "pass_all_args once, then none": case(
        f'<arg name="a" default="1"/><include file="$(dirname)/b.launch" {ALL}/>',
        "undeclared-arg",
        files={"b.launch": '<include file="$(dirname)/c.launch"/>', "c.launch": SHOW},
    ),
    "pass_all_args passes a group's args": case(
        f'<group><arg name="a" default="1"/><include file="$(dirname)/b.launch" {ALL}/></group>', files={"b.launch": SHOW}
    ),
    "pass_all_args, and the value there is not passed back": passing(
        '<arg name="a" value="3"/>' + SHOW, "", ALL, '<arg name="a" default="1"/>', '<param name="y" value="$(arg a)"/>'
    ),
    "pass_all_args is a boolean": passing("", "", 'pass_all_args="1"', "", "", "invalid-value"),
    "pass_all_args is not empty": passing("", "", 'pass_all_args=""', "", "", "invalid-value"),
    "pass_all_args=false": passing("", '<arg name="a" value="1"/>', 'pass_all_args="FALSE"', "", "", "include-undeclared-arg"),
    # files
    "an include of a file that is not there": case('<include file="$(dirname)/no.launch"/>', "include-not-found"),
    "an include of nothing": case('<include file=""/>', "include-not-found"),
    "an include without file": case("<include/>", "missing-attribute"),
    "an include that is switched off": case('<include file="$(dirname)/no.launch" if="0" pass_all_args="x"/>[[n]]'),
    "an include of a directory": case('<include file="$(dirname)"/>', "include-not-found"),
    "an include of a file that is no launch file": case(
        '<include file="$(dirname)/x.xml"/>', "include-not-loadable", files={"x.xml": "<robot/>"}
    ),
    "an include of a file that is not well-formed": case(
        '<include file="$(dirname)/x.xml"/>', "include-not-loadable", files={"x.xml": "<launch>"}
    ),
    "an include by a relative name": case(
        '<include file="d/inner.launch"/>', files={"d/inner.launch": '<include file="other.launch"/>', "other.launch": "[[n]]"}
    ),
    "a name with two dots": case(
        '<include file="$(dirname)/d/../inner.launch"/>', files={"inner.launch": '<param name="x" value="$(dirname)"/>', "d/x": ""}
    ),
    "a file that includes itself": case('<include file="$(dirname)/main.launch"/>', "include-cycle"),
    "two files that include each other": case(GO, "include-cycle", files={"inner.launch": '<include file="$(dirname)/main.launch"/>'}),
    "a file that includes itself, once": case(
        '<arg name="again" default="true"/>[[n ns="$(arg again)"]]<include file="$(dirname)/main.launch" if="$(arg again)">'
        '<arg name="again" value="false"/></include>'
    ),
    "a file that counts down": case(
        '<arg name="k" default="5"/>[[n$(arg k)]]<include file="$(dirname)/main.launch" if="$(eval k &gt; 0)">'
        '<arg name="k" value="$(eval k - 1)"/></include>'
    ),
    "an included file that is deprecated": case(GO, files={"inner.launch": '<launch deprecated="use the other one">[[n]]</launch>'}),
    # conditions
    "conditions in every spelling": case(
        "".join(
            f'<param name="p{number}" value="1" if="{word}"/>'
            for number, word in enumerate(["true", "1", "TRUE", " true ", "0", "False", " 0"])
        )
    ),
    "unless in every spelling": case(
        "".join(f'<param name="p{number}" value="1" unless="{word}"/>' for number, word in enumerate(["true", "1", "0", "fALSE", " 0\t"]))
    ),
    "if and unless": case('[[n if="1" unless="0"]]', "if-and-unless"),
    "if and unless, both empty": case('<group if="" unless=""/>', "if-and-unless"),
    "an empty condition": case('[[n if=""]]', "condition-not-boolean"),
    "a condition that is a word": case('<remap if="yes"/>', "condition-not-boolean"),
    "a condition that is a number": case('<arg name="a" default="2"/><env unless="$(arg a)"/>', "condition-not-boolean"),
    "a condition that is a float": case('<arg name="a" default="1.0"/><group if="$(arg a)"/>', "condition-not-boolean"),
    "an unknown arg in a condition": case('<group if="$(arg a)"/>', "undeclared-arg"),
    "a condition from $(eval)": case('<arg name="a" default="5"/>[[n if="$(eval a == 5)"]][[m if="$(eval a == \'5\')"]]'),
    "a condition of each kind of tag": case(
        '<arg name="a" if="0"/><group if="0"/><node if="0"/><test if="0"/><param if="0"/><remap if="0"/><machine if="0"/>'
        '<rosparam if="0"/><include if="0"/><env if="0"/>[[n | <param if="0"/><rosparam if="0"/><remap if="0"/><env if="0"/>]]'
    ),
    "what is in a group that is switched off": case('<group if="0" ns=""><node/><bad/><group if="x"/></group>[[n]]'),
    "an unknown tag that is switched off": case('<bad if="0"/>[[n]]'),
    "a condition on the root": case('<launch if="false" unless="false">[[n]]</launch>', "if-and-unless"),
    "a false condition on the root": case('<launch if="false">[[n]]</launch>'),
    "a condition with an arg on the root": case('<launch if="$(arg x)">[[n]]</launch>', "condition-on-launch"),
    "a wrong condition on the root": case('<launch unless="maybe">[[n]]</launch>', "condition-not-boolean"),
    "a condition with an arg on an included root": case(GO, "condition-on-launch", files={"inner.launch": '<launch if="$(arg x)"/>'}),
}
