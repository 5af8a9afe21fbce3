from jinja2.runtime import LoopContext, Macro, Markup, Namespace, TemplateNotFound, TemplateReference, TemplateRuntimeError, Undefined, escape, identity, internalcode, markup_join, missing, str_join
name = 'library.html'

def root(context, missing=missing):
    resolve = context.resolve_or_missing
    undefined = environment.undefined
    concat = environment.concat
    cond_expr_undefined = Undefined
    if 0: yield None
    l_0_data = resolve('data')
    try:
        t_1 = environment.filters['join']
    except KeyError:
        @internalcode
        def t_1(*unused):
            raise TemplateRuntimeError("No filter named 'join' found.")
    try:
        t_2 = environment.filters['length']
    except KeyError:
        @internalcode
        def t_2(*unused):
            raise TemplateRuntimeError("No filter named 'length' found.")
    pass
    yield '<h2>Library</h2>\n<p>What the programs on this page are known to do, and how that is known: from a run (dynamic), from source code (static), or written by hand (manual).</p>\n<noscript>\n'
    if (not environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'library')):
        pass
        yield '<p class="empty">Nothing is known of any program on this page.</p>\n'
    l_1_loop = missing
    for l_1_program, l_1_loop in LoopContext(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'library'), undefined):
        _loop_vars = {}
        pass
        yield '<details class="program" id="program-'
        yield escape(environment.getattr(l_1_loop, 'index0'))
        yield '" data-index="'
        yield escape(environment.getattr(l_1_loop, 'index0'))
        yield '">\n<summary><h3>'
        yield escape((environment.getattr(l_1_program, 'name') if (environment.getattr(l_1_program, 'kind') == 'nodelet') else markup_join((environment.getattr(l_1_program, 'package'), '/', environment.getattr(l_1_program, 'name'), ))))
        yield '</h3> <span class="number">'
        yield escape(t_2(environment.getattr(l_1_program, 'interface')))
        yield '</span>'
        if (environment.getattr(l_1_program, 'kind') == 'nodelet'):
            pass
            yield ' nodelet of '
            yield escape(environment.getattr(l_1_program, 'package'))
        yield '</summary>\n'
        if environment.getattr(l_1_program, 'status'):
            pass
            yield '<p>'
            yield escape(environment.getattr(l_1_program, 'status'))
            yield '</p>\n'
        if environment.getattr(l_1_program, 'interface'):
            pass
            yield '<table>\n<thead><tr><th scope="col">Kind</th><th scope="col">Name</th><th scope="col">Type</th><th scope="col">Detail</th><th scope="col">Evidence</th></tr></thead>\n<tbody>\n'
            for l_2_row in environment.getattr(l_1_program, 'interface'):
                _loop_vars = {}
                pass
                yield '<tr><td>'
                yield escape(environment.getattr(l_2_row, 'category'))
                yield '</td><td>'
                yield escape(environment.getattr(l_2_row, 'name'))
                yield '</td><td>'
                yield escape(environment.getattr(l_2_row, 'type'))
                yield '</td><td>'
                yield escape(environment.getattr(l_2_row, 'detail'))
                yield '</td><td>'
                yield escape(t_1(context.eval_ctx, environment.getattr(l_2_row, 'evidence'), '; '))
                yield '</td></tr>\n'
            l_2_row = missing
            yield '</tbody>\n</table>\n'
        for (l_2_category, l_2_why) in environment.getattr(l_1_program, 'open'):
            _loop_vars = {}
            pass
            yield '<p class="note">It may have more '
            yield escape(l_2_category)
            yield ' than are listed: '
            yield escape(l_2_why)
            yield '</p>\n'
        l_2_category = l_2_why = missing
        yield '</details>\n'
    l_1_loop = l_1_program = missing
    if environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'libraryLeftOut'):
        pass
        yield '<p class="note">'
        yield escape(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'libraryLeftOut'))
        yield ' more programs are in the libraries that were given: <code>launchlint library show</code> lists them.</p>\n'
    yield '</noscript>\n'

blocks = {}
debug_info = '4=25&7=29&8=33&9=37&10=46&11=49&13=51&17=54&18=58&23=70&24=74&28=81&29=84'