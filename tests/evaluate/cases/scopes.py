"""Scopes, namespaces, remaps, environment, ``~params`` and machines: what acts on what, and in which order."""

from __future__ import annotations

from tests.evaluate.comparison import case

INNER = {"inner.launch": "[[inner]]"}
GO = '<include file="$(dirname)/inner.launch"/>'

SCOPES = {
    # remaps
    "a remap acts on the nodes that follow": case('[[a]]<remap from="x" to="y"/>[[b]]'),
    "a remap does not leave its group": case('<group><remap from="x" to="y"/>[[a]]</group>[[b]]'),
    "a group sees the remaps above it only": case('<remap from="x" to="y"/><group>[[a]]</group><remap from="z" to="w"/>[[b]]'),
    "a remap to a name with a digit first": case('<remap from="x" to="1a"/>', "invalid-remap-name"),
    "a later remap of one spelling replaces": case('<remap from="x" to="a"/><remap from="z" to="b"/><remap from="x" to="c"/>[[n]]'),
    "two spellings of one name are both passed": case('<remap from="x" to="a"/><remap from="/x" to="b"/>[[n]]'),
    "remaps are canonicalised": case('<remap from="//x//y/" to="z/"/>[[n]]'),
    "canonical spellings replace each other": case('<remap from="x/" to="a"/><remap from="x" to="b"/>[[n]]'),
    "an inner remap of one spelling drops the outer": case(
        '<remap from="x" to="a"/><remap from="z" to="b"/><group><remap from="x" to="c"/>[[n]]</group>[[m]]'
    ),
    "a node's remap drops the scope's": case(
        '<remap from="x" to="a"/><remap from="z" to="b"/>[[n | <remap from="x" to="c"/><remap from="q" to="r"/>]][[m]]'
    ),
    "a node's own remaps replace each other": case('[[n | <remap from="x" to="c"/><remap from="q" to="r"/><remap from="x" to="d"/>]]'),
    "remaps go into includes, after their own come the file's": case(
        '<remap from="x" to="a"/><remap from="y" to="b"/><include file="$(dirname)/inner.launch"/>[[n]]',
        files={"inner.launch": '<remap from="y" to="c"/>[[inner]]<remap from="x" to="d"/>[[last]]'},
    ),
    "remaps do not come out of includes": case(GO + "[[n]]", files={"inner.launch": '<remap from="x" to="y"/>[[inner]]'}),
    "remaps through group and include and group": case(
        '<remap from="x" to="a"/><group><remap from="y" to="b"/>' + GO + "</group>",
        files={"inner.launch": '<group ns="g"><remap from="x" to="c"/>[[inner]]</group>[[other]]'},
    ),
    "an empty remap": case('<remap from="" to="y"/>', "invalid-remap-name"),
    "an empty remap target in a node": case('[[n | <remap from="x" to=""/>]]', "invalid-remap-name"),
    "a remap of slashes only is the root": case('<remap from="x" to="//"/>[[n]]'),
    "a remap of the root": case('<remap from="x" to="/"/>[[n]]'),
    "an illegal remap name": case('<remap from="x-y" to="y"/>', "invalid-remap-name"),
    "a remap name with a blank": case('<remap from="x" to=" y"/>', "invalid-remap-name"),
    "a private remap": case('<remap from="~x" to="~y"/>[[n]]'),
    "a remap name that begins with an underscore": case('<remap from="_x" to="y"/>', "invalid-remap-name"),
    "a remap name of other letters": case('<remap from="größe" to="y"/>[[n]]'),
    "a remap without to": case('<remap from="x"/>', "missing-attribute"),
    "a wrong remap that is switched off": case('<remap from="x" if="0"/><remap bad="x" if="false"/>[[n]]'),
    "children and text of a remap are not looked at": case('<remap from="x" to="y"><remap from="1"/>text</remap>[[n]]'),
    # namespaces
    "namespaces join": case('<group ns="a"><group ns="b/c">[[n ns="d"]]</group></group>'),
    "absolute namespaces replace": case('<group ns="a"><group ns="/b">[[n]][[m ns="/c/d"]]</group></group>'),
    "slashes in namespaces": case('<group ns="a//b/">[[n ns="c//d/"]]<param name="p" value="1"/></group>'),
    "the root as a namespace": case('<group ns="a"><group ns="/">[[n]]</group></group>'),
    "an empty group namespace": case('<group ns=""/>', "conflicting-attributes"),
    "an empty node namespace": case('[[n ns=""]]', "conflicting-attributes"),
    "an empty include namespace": case('<include file="$(dirname)/inner.launch" ns=""/>', "conflicting-attributes", files=INNER),
    "an empty namespace from an arg": case('<arg name="a" default=""/><group ns="$(arg a)"/>', "conflicting-attributes"),
    "a private group namespace": case('<group ns="~a">[[n]]</group>', "invalid-namespace"),
    "a private include namespace": case('<include file="$(dirname)/inner.launch" ns="~"/>', "invalid-namespace", files=INNER),
    "a private node namespace": case('[[n ns="~x"]]', "invalid-namespace"),
    "namespaces are not checked": case('<group ns="my-robot"><group ns="robot 1">[[n ns="1"]]</group></group>'),
    "an include's namespace": case('<group ns="a"><include file="$(dirname)/inner.launch" ns="b"/></group>', files=INNER),
    "an include's absolute namespace": case('<group ns="a"><include file="$(dirname)/inner.launch" ns="/b/"/></group>', files=INNER),
    "a namespace given on the command line": case('[[n]]<param name="x" value="1"/>', args={"__ns": "robot"}),
    "a namespace from the environment": case('[[n]]<param name="x" value="1"/>', environment={"ROS_NAMESPACE": "/robot/"}),
    "a namespace from both": case("[[n]]", args={"__ns": "/b"}, environment={"ROS_NAMESPACE": "/a"}),
    "the namespace on the command line is an arg": case('<param name="x" value="$(arg __ns)"/>', args={"__ns": "b"}),
    # environment
    "env acts on what follows": case('[[a]]<env name="A" value="1"/>[[b]]<env name="A" value="2"/>[[c]]'),
    "env in groups": case('<env name="A" value="1"/><group><env name="B" value="2"/>[[a]]</group>[[b]]'),
    "env of a node": case('<env name="A" value="1"/>[[a | <env name="A" value="2"/><env name="C" value=""/>]][[b]]'),
    "env of an include": case(
        '<env name="A" value="1"/><include file="$(dirname)/inner.launch"><env name="B" value="2"/></include>[[n]]',
        files={"inner.launch": '[[i]]<env name="C" value="3"/>[[j]]'},
    ),
    "an env without a name": case('<env name="" value="1"/>', "invalid-value"),
    "an env without a value": case('[[n | <env name="A"/>]]', "missing-attribute"),
    "$(env) does not see <env>": case('<env name="A" value="1"/><param name="x" value="$(env A)"/>', "env-unset"),
    # ~params
    "a ~param goes to every later node": case('[[a]]<param name="~x" value="1"/>[[b]]<group ns="g">[[c]]</group>'),
    "a ~param does not leave its group": case('<group><param name="~x" value="1"/>[[a]]</group>[[b]]'),
    "a ~param of a group with one outside": case('<param name="~y" value="0"/><group><param name="~x" value="1"/>[[a]]</group>[[b]]'),
    "a ~param does not come out of an include": case(GO + "[[n]]", files={"inner.launch": '<param name="~x" value="1"/>[[i]]'}),
    "a ~param comes out of an include where one was set before": case(
        '<param name="~y" value="0"/>' + GO + "[[n]]",
        files={"inner.launch": '<param name="~x" value="1"/>[[i]]<param name="~y" value="5"/>'},
    ),
    "a ~param leaks through two includes": case(
        '<param name="~y" value="0"/>' + GO + "[[n]]",
        files={"inner.launch": '<include file="$(dirname)/deep.launch"/>[[i]]', "deep.launch": '[[d]]<param name="~z" value="1"/>'},
    ),
    "a ~param of a group in an include does not leak": case(
        '<param name="~y" value="0"/>' + GO + "[[n]]", files={"inner.launch": '<group><param name="~x" value="1"/>[[i]]</group>'}
    ),
    "a ~param leaks from an include in a group to that group": case(
        '<param name="~y" value="0"/><group>' + GO + "[[m]]</group>[[n]]", files={"inner.launch": '<param name="~x" value="1"/>'}
    ),
    "a group in an include, with an include that sets a ~param": case(
        '<param name="~y" value="0"/>' + GO + "[[n]]",
        files={
            "inner.launch": '<group><include file="$(dirname)/deep.launch"/>[[g]]</group>[[i]]',
            "deep.launch": '<param name="~z" value="1"/>',
        },
    ),
    "the first ~param set in an include, then a second include": case(
        GO + '<include file="$(dirname)/other.launch"/>[[n]]',
        files={
            "inner.launch": '<param name="~x" value="1"/><include file="$(dirname)/deep.launch"/>[[i]]',
            "deep.launch": '<param name="~z" value="1"/>',
            "other.launch": "[[o]]",
        },
    ),
    "a ~param is set again": case('<param name="~x" value="1"/><param name="~y" value="2"/><param name="~x" value="3"/>[[n]]'),
    "a node's param wins over a ~param": case('<param name="~x" value="1"/>[[n | <param name="x" value="2"/>]]'),
    "a ~param and a node's rosparam": case('<param name="~x" value="1"/>[[n | <rosparam>{x: 2, y: 3}</rosparam>]]'),
    "a node's rosparam and param": case('[[n | <param name="x" value="1"/><rosparam>{x: 2}</rosparam>]]'),
    "a ~param inside a node": case('[[n | <param name="~x" value="2"/><param name="~/y" value="3"/>]]'),
    "a global param inside a node": case('<group ns="g">[[n | <param name="/x" value="2"/><param name="a//b/" value="3"/>]]</group>'),
    "a ~param acts on tests too": case('<param name="~x" value="1"/><test pkg="p" type="t" test-name="t"/>'),
    "a bare ~ as a param": case('<param name="~" value="1"/>[[n]]'),
    "a ~ with a slash": case('<param name="~/x" value="1"/>[[n]]'),
    # machines
    "a default machine acts on what follows": case('[[a]]<machine name="m" address="h" default="true"/>[[b]][[c machine="m"]]'),
    "a default machine comes out of a group": case('<group><machine name="m" address="h" default="true"/>[[a]]</group>[[b]]'),
    "a default machine comes out of an include": case(
        GO + "[[b]]", files={"inner.launch": '<machine name="m" address="h" default="true"/>'}
    ),
    "a default machine goes into an include": case('<machine name="m" address="h" default="TRUE"/>' + GO, files=INNER),
    "a default machine of an included group": case(
        '<machine name="m" address="h" default="true"/>' + GO + "[[b]]",
        files={"inner.launch": '[[i]]<group><machine name="o" address="h" default="true"/></group>[[j]]'},
    ),
    "machines in full": case(
        '<machine name="m" address="h" env-loader="/e.sh" ssh-port="2200" user="u" password="" default="never" timeout="3.5"/>'
        '<machine name="o" address="localhost" default="" user="" ssh-port="" env-loader=""/>[[a machine="m"]]'
    ),
    "a machine may come later": case('[[a machine="m"]]<machine name="m" address="h"/>'),
    "an unknown machine": case('[[a machine="m"]]', "unknown-machine"),
    "an unknown machine of a test": case('<test pkg="p" type="t" test-name="t" machine="m"/>', "unknown-machine"),
    "an empty machine is the default one": case('<machine name="m" address="h" default="true"/>[[a machine=""]]'),
    "equal machines": case('<machine name="m" address="h"/><machine name="m" address="h" default="true"/>[[a]]'),
    "machines that differ": case('<machine name="m" address="h"/><machine name="m" address="h" user="u"/>', "machine-conflict"),
    "machines that differ in whether nodes may be assigned": case(
        '<machine name="m" address="h"/><machine name="m" address="h" default="never"/>', "machine-conflict"
    ),
    "machines that differ in an empty password": case('<machine name="m" address="h"/><machine name="m" address="h" password=""/>'),
    "a machine without a name is the local one": case('<machine name="" address="h"/>', "invalid-value"),
    "a machine without an address": case('<machine name="m"/>', "missing-attribute"),
    "a machine's default is a word": case('<machine name="m" address="h" default="yes"/>', "invalid-value"),
    "a machine's port is a number": case('<machine name="m" address="h" ssh-port="x"/>', "invalid-value"),
    "a machine's timeout is above 0": case('<machine name="m" address="h" timeout="0"/>', "invalid-value"),
    "a machine's timeout is not empty": case('<machine name="m" address="h" timeout=""/>', "invalid-value"),
    "a machine of before Fuerte": case('<machine name="m" address="h" ros-ip="1"/>', "deprecated-construct"),
    "an empty attribute of before Fuerte": case('<machine name="m" address="h" ros-ip=""/>'),
    "env in a machine": case('<machine name="m" address="h"><env name="A" value="1"/></machine>', "deprecated-construct"),
    "env in a machine, switched off, is refused too": case(
        '<machine name="m" address="h"><env name="A" value="1" if="0"/></machine>', "deprecated-construct"
    ),
    "another tag in a machine": case('<machine name="m" address="h"><ENV/><param/></machine>'),
    # clear_params
    "clear_params of a group": case('<group ns="a//b" clear_params="true"><param name="x" value="1"/></group>'),
    "clear_params in any case": case('<group ns="a" clear_params="TRUE"/><group ns="b" clear_params="False"/>'),
    "clear_params without a namespace": case('<group clear_params="true"/>', "conflicting-attributes"),
    "no clear_params without a namespace": case('<group clear_params="false"/><group clear_params=""/>'),
    "clear_params is no 1": case('<group ns="a" clear_params="1"/>', "invalid-value"),
    "clear_params with a blank": case('<group ns="a" clear_params=" "/>', "invalid-value"),
    "clear_params of an include": case('<include file="$(dirname)/inner.launch" ns="a" clear_params="true"/>', files=INNER),
    "clear_params of an include without ns": case(
        '<include file="$(dirname)/inner.launch" clear_params="true"/>', "conflicting-attributes", files=INNER
    ),
    "clear_params of a node": case('<group ns="a">[[n clear_params="true"]][[m ns="b" clear_params="true"]]</group>'),
    "clear_params of a node without a name": case('[[ clear_params="true"]]', "conflicting-attributes"),
    "clear_params of a test": case('<test pkg="p" type="t" test-name="t" clear_params="true"/>'),
    "clear_params of nothing in an arg": case('<arg name="a" default=""/><group clear_params="$(arg a)"/>'),
    # order
    "a node sees what is above it, by kinds": case(
        '<remap from="a" to="b"/>[[n1]]<env name="A" value="1"/>[[n2]]<param name="~p" value="1"/>[[n3]]'
        '<machine name="m" address="h" default="true"/>[[n4]]'
    ),
    "groups in groups leak nothing": case(
        '<group ns="a"><group ns="b"><env name="A" value="1"/><remap from="x" to="y"/>'
        '<param name="~p" value="1"/></group>[[n]]</group>[[m]]'
    ),
    "one file included twice": case(
        '<include file="$(dirname)/inner.launch" ns="a"/><remap from="x" to="y"/><include file="$(dirname)/inner.launch" ns="b"/>',
        files=INNER,
    ),
    "one file included twice in one namespace": case(GO + GO, "duplicate-node", files=INNER),
    "one file included in the same way after a remap": case(
        "<group>" + GO + '</group><remap from="x" to="y"/><env name="A" value="1"/>' + GO,
        files={"inner.launch": '[[]]<param name="x" value="1"/>'},
    ),
}
