from jinja2.runtime import LoopContext, Macro, Markup, Namespace, TemplateNotFound, TemplateReference, TemplateRuntimeError, Undefined, escape, identity, internalcode, markup_join, missing, str_join
name = 'findings.html'

def root(context, missing=missing):
    resolve = context.resolve_or_missing
    undefined = environment.undefined
    concat = environment.concat
    cond_expr_undefined = Undefined
    if 0: yield None
    l_0_findings = resolve('findings')
    try:
        t_1 = environment.filters['length']
    except KeyError:
        @internalcode
        def t_1(*unused):
            raise TemplateRuntimeError("No filter named 'length' found.")
    pass
    yield '<details class="table" open>\n<summary><h2>Findings <span class="number">'
    yield escape(t_1((undefined(name='findings') if l_0_findings is missing else l_0_findings)))
    yield '</span></h2></summary>\n'
    if (undefined(name='findings') if l_0_findings is missing else l_0_findings):
        pass
        yield '<div class="wide" tabindex="0" role="region" aria-label="Findings">\n<table id="table-findings">\n<thead><tr><th scope="col">Severity</th><th scope="col">Rule</th><th scope="col">Finding</th><th scope="col">Place</th><th scope="col">What to do</th></tr></thead>\n<tbody>\n'
        for l_1_row in (undefined(name='findings') if l_0_findings is missing else l_0_findings):
            _loop_vars = {}
            pass
            yield '<tr id="findings-'
            yield escape(environment.getattr(l_1_row, 'number'))
            yield '" data-index="'
            yield escape(environment.getattr(l_1_row, 'number'))
            yield '" class="'
            yield escape(environment.getitem(environment.getattr(l_1_row, 'cells'), 0))
            yield '"><td>'
            yield escape(environment.getitem(environment.getattr(l_1_row, 'cells'), 0))
            yield '</td><td>'
            yield escape(environment.getitem(environment.getattr(l_1_row, 'cells'), 1))
            yield ' '
            yield escape(environment.getitem(environment.getattr(l_1_row, 'cells'), 2))
            yield '</td><td>'
            yield escape(environment.getitem(environment.getattr(l_1_row, 'cells'), 3))
            yield '</td><td>'
            yield escape(environment.getitem(environment.getattr(l_1_row, 'cells'), 4))
            yield '</td><td>'
            yield escape(environment.getitem(environment.getattr(l_1_row, 'cells'), 5))
            yield '</td></tr>\n'
        l_1_row = missing
        yield '</tbody>\n</table>\n</div>\n'
    else:
        pass
        yield '<p class="empty">No rule found anything wrong. What a node does is only known from libraries: mistakes at nodes that are listed as unknown below cannot be seen.</p>\n'
    yield '</details>\n'

blocks = {}
debug_info = '2=19&3=21&8=24&9=28'