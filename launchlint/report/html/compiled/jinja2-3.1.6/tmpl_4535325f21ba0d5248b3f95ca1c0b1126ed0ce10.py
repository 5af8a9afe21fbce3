from jinja2.runtime import LoopContext, Macro, Markup, Namespace, TemplateNotFound, TemplateReference, TemplateRuntimeError, Undefined, escape, identity, internalcode, markup_join, missing, str_join
name = 'landing.html'

def root(context, missing=missing):
    resolve = context.resolve_or_missing
    undefined = environment.undefined
    concat = environment.concat
    cond_expr_undefined = Undefined
    if 0: yield None
    l_0_landing = resolve('landing')
    l_0_data = resolve('data')
    l_0_wrong = resolve('wrong')
    l_0_card = missing
    try:
        t_1 = environment.filters['length']
    except KeyError:
        @internalcode
        def t_1(*unused):
            raise TemplateRuntimeError("No filter named 'length' found.")
    try:
        t_2 = environment.filters['safe']
    except KeyError:
        @internalcode
        def t_2(*unused):
            raise TemplateRuntimeError("No filter named 'safe' found.")
    try:
        t_3 = environment.filters['urlencode']
    except KeyError:
        @internalcode
        def t_3(*unused):
            raise TemplateRuntimeError("No filter named 'urlencode' found.")
    pass
    def macro(l_1_each):
        t_4 = []
        if l_1_each is missing:
            l_1_each = undefined("parameter 'each' was not provided", name='each')
        pass
        t_4.append(
            '<li class="card',
        )
        if environment.getattr(l_1_each, 'level'):
            pass
            t_4.extend((
                ' ',
                escape(environment.getattr(l_1_each, 'level')),
            ))
        t_4.extend((
            '" data-entry="',
            escape(environment.getattr(l_1_each, 'entry')),
            '">\n<h3><a href="#entry=',
            escape(t_3(environment.getattr(l_1_each, 'address'))),
            '"><span class="card-directory">',
            escape(environment.getattr(l_1_each, 'directory')),
            '</span>',
            escape(environment.getattr(l_1_each, 'title')),
            '</a></h3>\n',
        ))
        if environment.getattr(l_1_each, 'picture'):
            pass
            t_4.append(
                escape(t_2(environment.getattr(l_1_each, 'picture'))),
            )
        else:
            pass
            t_4.extend((
                '<p class="no-picture">',
                escape(('no nodes known' if environment.getattr(l_1_each, 'doubtful') else 'no nodes')),
                '</p>',
            ))
        t_4.append(
            '\n<p class="card-verdict',
        )
        if environment.getattr(l_1_each, 'level'):
            pass
            t_4.extend((
                ' ',
                escape(environment.getattr(l_1_each, 'level')),
            ))
        t_4.append(
            '"',
        )
        if environment.getattr(l_1_each, 'why'):
            pass
            t_4.extend((
                ' title="',
                escape(environment.getattr(l_1_each, 'why')),
                '"',
            ))
        t_4.extend((
            '><b>',
            escape(environment.getattr(l_1_each, 'verdict')),
            '</b>',
        ))
        if environment.getattr(l_1_each, 'why'):
            pass
            t_4.extend((
                ': ',
                escape(environment.getattr(l_1_each, 'why')),
            ))
        t_4.extend((
            '</p>\n<p class="card-facts"><span>',
            escape(environment.getattr(l_1_each, 'nodes')),
            '</span>',
        ))
        if environment.getattr(l_1_each, 'sight'):
            pass
            t_4.append(
                '<span',
            )
            if environment.getattr(l_1_each, 'doubtful'):
                pass
                t_4.append(
                    ' class="unknown"',
                )
            t_4.extend((
                '>',
                escape(environment.getattr(l_1_each, 'sight')),
                '</span>',
            ))
        for l_2_count in environment.getattr(l_1_each, 'counts'):
            _loop_vars = {}
            pass
            t_4.extend((
                '<span class="badge ',
                escape(environment.getattr(l_2_count, 'severity')),
                '">',
                escape(environment.getattr(l_2_count, 'words')),
                '</span>',
            ))
        l_2_count = missing
        t_4.append(
            '</p>\n',
        )
        if environment.getattr(l_1_each, 'changes'):
            pass
            t_4.append(
                '<ul class="card-changes">',
            )
            for (l_2_looks, l_2_words) in environment.getattr(l_1_each, 'changes'):
                _loop_vars = {}
                pass
                t_4.extend((
                    '<li class="',
                    escape(l_2_looks),
                    '">',
                    escape(l_2_words),
                    '</li>',
                ))
            l_2_looks = l_2_words = missing
            t_4.append(
                '</ul>\n',
            )
        t_4.append(
            '</li>\n',
        )
        return concat(t_4)
    context.exported_vars.add('card')
    context.vars['card'] = l_0_card = Macro(environment, macro, 'card', ('each',), False, False, False, context.eval_ctx.autoescape)
    yield '<section id="landing" aria-label="Overview">\n<div class="landing-cards">\n'
    for l_1_group in (undefined(name='landing') if l_0_landing is missing else l_0_landing):
        _loop_vars = {}
        pass
        if environment.getattr(l_1_group, 'folded'):
            pass
            yield '<details class="card-group">\n<summary><h2>'
            yield escape(environment.getattr(l_1_group, 'title'))
            yield ' <span class="number">'
            yield escape(t_1(environment.getattr(l_1_group, 'cards')))
            yield '</span></h2>'
            if environment.getattr(l_1_group, 'said'):
                pass
                yield ' <span class="card-said">'
                yield escape(environment.getattr(l_1_group, 'said'))
                yield '</span>'
            yield '</summary>\n<ol class="cards">\n'
            for l_2_each in environment.getattr(l_1_group, 'cards'):
                _loop_vars = {}
                pass
                yield escape(context.call((undefined(name='card') if l_0_card is missing else l_0_card), l_2_each, _loop_vars=_loop_vars))
                yield '\n'
            l_2_each = missing
            yield '</ol>\n</details>\n'
        else:
            pass
            yield '<h2 tabindex="-1">'
            yield escape(environment.getattr(l_1_group, 'title'))
            yield ' <span class="number">'
            yield escape(t_1(environment.getattr(l_1_group, 'cards')))
            yield '</span></h2>\n<ol class="cards'
            if environment.getattr(l_1_group, 'changed'):
                pass
                yield ' changed'
            yield '">\n'
            for l_2_each in environment.getattr(l_1_group, 'cards'):
                _loop_vars = {}
                pass
                yield escape(context.call((undefined(name='card') if l_0_card is missing else l_0_card), l_2_each, _loop_vars=_loop_vars))
                yield '\n'
            l_2_each = missing
            yield '</ol>\n'
    l_1_group = missing
    yield '</div>\n<div class="landing-findings">\n<h2>Findings <span class="number">'
    yield escape(t_1(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'findings')))
    yield '</span></h2>\n'
    if (undefined(name='wrong') if l_0_wrong is missing else l_0_wrong):
        pass
        yield '<ul class="findings">\n'
        for l_1_each in (undefined(name='wrong') if l_0_wrong is missing else l_0_wrong):
            l_1_place = resolve('place')
            _loop_vars = {}
            pass
            yield '<li>'
            if context.call(environment.getattr(environment.getattr(l_1_each, 'first'), 'get'), 'since', _loop_vars=_loop_vars):
                pass
                yield '<span class="badge since">new</span> '
            yield '<span class="badge '
            yield escape(environment.getattr(environment.getattr(l_1_each, 'first'), 'severity'))
            yield '">'
            yield escape(environment.getattr(environment.getattr(l_1_each, 'first'), 'severity'))
            yield '</span> <code>'
            yield escape(environment.getattr(environment.getattr(l_1_each, 'first'), 'rule'))
            yield '</code>'
            if (environment.getattr(l_1_each, 'times') > 1):
                pass
                yield ' <span class="times">'
                yield escape(environment.getattr(l_1_each, 'times'))
                yield ' times</span>'
            yield '\n<a href="#finding='
            yield escape(environment.getattr(environment.getattr(l_1_each, 'first'), 'id'))
            yield '">'
            yield escape(environment.getattr(environment.getattr(l_1_each, 'first'), 'message'))
            yield '</a>\n<span class="note"><code class="place">'
            yield escape(environment.getattr(context.call((undefined(name='place') if l_1_place is missing else l_1_place), environment.getattr(environment.getattr(l_1_each, 'first'), 'place'), _loop_vars=_loop_vars), 'text'))
            yield '</code></span></li>\n'
        l_1_each = l_1_place = missing
        yield '</ul>\n'
    else:
        pass
        yield '<p class="empty">No rule found anything wrong.</p>\n'
    if environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'fixed'):
        pass
        yield '<h2>Fixed since '
        yield escape(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'base'))
        yield ' <span class="number">'
        yield escape(t_1(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'fixed')))
        yield '</span></h2>\n<ul class="findings fixed">\n'
        for l_1_each in environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'fixed'):
            _loop_vars = {}
            pass
            yield '<li><span class="badge since fixed">fixed</span> <code>'
            yield escape(environment.getattr(l_1_each, 'rule'))
            yield '</code> '
            yield escape(environment.getattr(l_1_each, 'message'))
            yield '</li>\n'
        l_1_each = missing
        yield '</ul>\n'
    yield '</div>\n</section>\n'

blocks = {}
debug_info = '1=33&2=41&3=51&4=58&6=73&7=102&8=134&9=139&15=160&16=163&18=166&20=176&21=179&26=186&27=190&28=194&29=197&36=203&37=205&39=208&40=213&42=229&43=233&49=240&50=243&52=247&53=251'