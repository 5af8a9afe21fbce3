from jinja2.runtime import LoopContext, Macro, Markup, Namespace, TemplateNotFound, TemplateReference, TemplateRuntimeError, Undefined, escape, identity, internalcode, markup_join, missing, str_join
name = 'unknown.html'

def root(context, missing=missing):
    resolve = context.resolve_or_missing
    undefined = environment.undefined
    concat = environment.concat
    cond_expr_undefined = Undefined
    if 0: yield None
    l_0_empty = resolve('empty')
    l_0_data = resolve('data')
    try:
        t_1 = environment.filters['length']
    except KeyError:
        @internalcode
        def t_1(*unused):
            raise TemplateRuntimeError("No filter named 'length' found.")
    pass
    yield '<details class="table" open id="unknown">\n<summary><h2>Unknown programs <span class="number">'
    yield escape(t_1(environment.getattr((undefined(name='empty') if l_0_empty is missing else l_0_empty), 'unknown')))
    yield '</span></h2></summary>\n'
    if environment.getattr((undefined(name='empty') if l_0_empty is missing else l_0_empty), 'unknown'):
        pass
        yield '<p>'
        if environment.getattr((undefined(name='empty') if l_0_empty is missing else l_0_empty), 'sight'):
            pass
            yield escape(environment.getattr((undefined(name='empty') if l_0_empty is missing else l_0_empty), 'sight'))
            yield '. '
        yield 'Nothing says what these programs do, so their connections are missing in the drawing, and rules that speak of what is missing weigh that they may be there.</p>\n'
        if environment.getattr(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'mend'), 'command'):
            pass
            yield '<p>To know those whose packages are here, run this, then make the page again:</p>\n<pre class="command" tabindex="0" role="group" aria-label="Command">'
            yield escape(environment.getattr(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'mend'), 'command'))
            yield '</pre>\n'
        if environment.getattr(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'mend'), 'advice'):
            pass
            yield '<p>'
            yield escape(environment.getattr(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'mend'), 'advice'))
            yield '.</p>\n'
        yield '<div class="wide" tabindex="0" role="region" aria-label="Unknown programs">\n<table id="table-unknown">\n<thead><tr><th scope="col">Program</th><th scope="col">Nodes</th><th scope="col">Why</th><th scope="col">What helps</th></tr></thead>\n<tbody>\n'
        for (l_1_program, l_1_count, l_1_reason, l_1_learn) in environment.getattr((undefined(name='empty') if l_0_empty is missing else l_0_empty), 'unknown'):
            _loop_vars = {}
            pass
            yield '<tr><td>'
            yield escape(l_1_program)
            yield '</td><td>'
            yield escape(l_1_count)
            yield '</td><td>'
            yield escape(l_1_reason)
            yield '</td><td>'
            yield escape(l_1_learn)
            yield '</td></tr>\n'
        l_1_program = l_1_count = l_1_reason = l_1_learn = missing
        yield '</tbody>\n</table>\n</div>\n'
    else:
        pass
        yield '<p class="empty">Every program is known.</p>\n'
    yield '</details>\n'

blocks = {}
debug_info = '2=20&3=22&4=25&5=30&7=33&9=35&10=38&16=41&17=45'