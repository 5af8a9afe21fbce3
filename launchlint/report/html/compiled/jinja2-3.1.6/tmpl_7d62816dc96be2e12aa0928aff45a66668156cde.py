from jinja2.runtime import LoopContext, Macro, Markup, Namespace, TemplateNotFound, TemplateReference, TemplateRuntimeError, Undefined, escape, identity, internalcode, markup_join, missing, str_join
name = 'overview.html'

def root(context, missing=missing):
    resolve = context.resolve_or_missing
    undefined = environment.undefined
    concat = environment.concat
    cond_expr_undefined = Undefined
    if 0: yield None
    l_0_empty = resolve('empty')
    l_0_entry_title = resolve('entry_title')
    l_0_data = resolve('data')
    l_0_overview = resolve('overview')
    pass
    if environment.getattr((undefined(name='empty') if l_0_empty is missing else l_0_empty), 'entries'):
        pass
        yield '<p class="empty">There is no launch file to show. Give files, or a directory that holds some: <code>launchlint report robot.launch -o report.html</code>.</p>\n'
    elif environment.getattr((undefined(name='empty') if l_0_empty is missing else l_0_empty), 'nodes'):
        pass
        yield '<p class="empty">Nothing to draw: '
        yield escape(('which nodes are started is not known' if environment.getattr((undefined(name='empty') if l_0_empty is missing else l_0_empty), 'open') else 'no node is started'))
        yield '.'
        for l_1_entry in environment.getattr((undefined(name='empty') if l_0_empty is missing else l_0_empty), 'refused')[:1]:
            _loop_vars = {}
            pass
            yield ' '
            if (environment.getattr(l_1_entry, 'verdict') == 'refused'):
                pass
                yield escape(environment.getattr(l_1_entry, 'launcher'))
                yield ' refuses '
                yield escape(context.call((undefined(name='entry_title') if l_0_entry_title is missing else l_0_entry_title), l_1_entry, _loop_vars=_loop_vars))
            else:
                pass
                yield 'Whether '
                yield escape(environment.getattr(l_1_entry, 'launcher'))
                yield ' loads '
                yield escape(context.call((undefined(name='entry_title') if l_0_entry_title is missing else l_0_entry_title), l_1_entry, _loop_vars=_loop_vars))
                yield ' cannot be told'
            yield ': '
            yield escape(environment.getattr(l_1_entry, 'why'))
            yield '.'
        l_1_entry = missing
        yield '</p>\n'
    else:
        pass
        yield '<noscript><p class="note">The drawing needs JavaScript. Everything it shows stands in the tables below.</p></noscript>\n<h2>'
        yield escape(context.call((undefined(name='entry_title') if l_0_entry_title is missing else l_0_entry_title), environment.getitem(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'entries'), 0)))
        yield '</h2>\n'
        if (environment.getattr(environment.getitem(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'entries'), 0), 'verdict') != 'loads'):
            pass
            yield '<p class="empty">'
            if (environment.getattr(environment.getitem(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'entries'), 0), 'verdict') == 'refused'):
                pass
                yield escape(environment.getattr(environment.getitem(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'entries'), 0), 'launcher'))
                yield ' refuses this file'
            else:
                pass
                yield 'Whether '
                yield escape(environment.getattr(environment.getitem(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'entries'), 0), 'launcher'))
                yield ' loads this file cannot be told'
            yield ': '
            yield escape(environment.getattr(environment.getitem(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'entries'), 0), 'why'))
            yield '. Shown is what it would start otherwise, as far as that can be told.</p>\n'
        if environment.getattr(environment.getitem(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'entries'), 0), 'withArgs'):
            pass
            yield '<p class="empty">'
            yield escape(environment.getattr(environment.getitem(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'entries'), 0), 'withArgs'))
            yield '</p>\n'
        yield '<table id="overview">\n<thead><tr><th scope="col">Namespace</th><th scope="col">Nodes</th><th scope="col">Unknown</th></tr></thead>\n<tbody>\n'
        for (l_1_name, l_1_nodes, l_1_unknown) in (undefined(name='overview') if l_0_overview is missing else l_0_overview):
            _loop_vars = {}
            pass
            yield '<tr><td>'
            yield escape(l_1_name)
            yield '</td><td>'
            yield escape(l_1_nodes)
            yield '</td><td>'
            yield escape(l_1_unknown)
            yield '</td></tr>\n'
        l_1_name = l_1_nodes = l_1_unknown = missing
        yield '</tbody>\n</table>\n'

blocks = {}
debug_info = '1=15&3=18&4=21&7=47&8=49&9=52&11=64&12=67&17=70&18=74'