from jinja2.runtime import LoopContext, Macro, Markup, Namespace, TemplateNotFound, TemplateReference, TemplateRuntimeError, Undefined, escape, identity, internalcode, markup_join, missing, str_join
name = 'page.html'

def root(context, missing=missing):
    resolve = context.resolve_or_missing
    undefined = environment.undefined
    concat = environment.concat
    cond_expr_undefined = Undefined
    if 0: yield None
    l_0_policy = resolve('policy')
    l_0_data = resolve('data')
    l_0_names = resolve('names')
    l_0_style = resolve('style')
    l_0_verdict = resolve('verdict')
    l_0_counts = resolve('counts')
    l_0_landing = resolve('landing')
    l_0_tables = resolve('tables')
    l_0_json = resolve('json')
    l_0_scripts = resolve('scripts')
    l_0_parts = missing
    try:
        t_1 = environment.filters['length']
    except KeyError:
        @internalcode
        def t_1(*unused):
            raise TemplateRuntimeError("No filter named 'length' found.")
    try:
        t_2 = environment.filters['replace']
    except KeyError:
        @internalcode
        def t_2(*unused):
            raise TemplateRuntimeError("No filter named 'replace' found.")
    try:
        t_3 = environment.filters['safe']
    except KeyError:
        @internalcode
        def t_3(*unused):
            raise TemplateRuntimeError("No filter named 'safe' found.")
    try:
        t_4 = environment.filters['urlencode']
    except KeyError:
        @internalcode
        def t_4(*unused):
            raise TemplateRuntimeError("No filter named 'urlencode' found.")
    pass
    l_0_parts = context.vars['parts'] = environment.get_template('parts.html', 'page.html')._get_default_module(context)
    context.exported_vars.discard('parts')
    yield '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<meta http-equiv="Content-Security-Policy" content="'
    yield escape((undefined(name='policy') if l_0_policy is missing else l_0_policy))
    yield '">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n<meta name="referrer" content="no-referrer">\n<meta name="color-scheme" content="light dark">\n<meta name="generator" content="launchlint '
    yield escape(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'version'))
    yield '">\n<title>'
    yield escape(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'title'))
    yield ' – launchlint</title>\n'
    if (undefined(name='names') if l_0_names is missing else l_0_names):
        pass
        yield '<link rel="stylesheet" href="'
        yield escape(t_4(environment.getitem((undefined(name='names') if l_0_names is missing else l_0_names), 'style.css')))
        yield '">\n'
    else:
        pass
        yield '<style>'
        yield escape(t_3((undefined(name='style') if l_0_style is missing else l_0_style)))
        yield '</style>\n'
    yield '</head>\n<body>\n<a class="skip" href="#tables">Skip to the tables</a>\n<header id="bar">\n<h1>'
    yield escape(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'title'))
    yield '</h1>\n<p id="verdict" class="'
    yield escape(environment.getitem((undefined(name='verdict') if l_0_verdict is missing else l_0_verdict), 0))
    yield '">'
    yield escape(environment.getitem((undefined(name='verdict') if l_0_verdict is missing else l_0_verdict), 1))
    if environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'base'):
        pass
        yield ', compared with '
        yield escape(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'base'))
    yield '</p>\n<ul id="counts">\n'
    for l_1_count in (undefined(name='counts') if l_0_counts is missing else l_0_counts):
        _loop_vars = {}
        pass
        yield '<li class="'
        yield escape((t_2(context.eval_ctx, environment.getattr(l_1_count, 'word'), 's', '') if (context.call(environment.getattr(environment.getattr(l_1_count, 'word'), 'rstrip'), 's', _loop_vars=_loop_vars) in ('error', 'warning', 'info')) else ''))
        yield '"><b>'
        yield escape(environment.getattr(l_1_count, 'number'))
        yield '</b> '
        yield escape(environment.getattr(l_1_count, 'word'))
        yield '</li>\n'
    l_1_count = missing
    yield '</ul>\n<div id="controls"></div>\n<p id="pages"><a href="#tables">Tables</a> <a href="#library">Library</a></p>\n</header>\n<nav id="tree" aria-label="Nodes"></nav>\n<main id="stage">\n'
    if (undefined(name='landing') if l_0_landing is missing else l_0_landing):
        pass
        template = environment.get_template('landing.html', 'page.html')
        gen = template.root_render_func(template.new_context(context.get_all(), True, {'parts': l_0_parts}))
        try:
            for event in gen:
                yield event
        finally: gen.close()
    yield '<div id="drawing">\n'
    template = environment.get_template('overview.html', 'page.html')
    gen = template.root_render_func(template.new_context(context.get_all(), True, {'parts': l_0_parts}))
    try:
        for event in gen:
            yield event
    finally: gen.close()
    yield '</div>\n</main>\n<aside id="panel" aria-label="Selection"></aside>\n<section id="tables" aria-label="Tables">\n<noscript>\n'
    template = environment.get_template('findings.html', 'page.html')
    gen = template.root_render_func(template.new_context(context.get_all(), True, {'parts': l_0_parts}))
    try:
        for event in gen:
            yield event
    finally: gen.close()
    for l_1_table in (undefined(name='tables') if l_0_tables is missing else l_0_tables):
        _loop_vars = {}
        pass
        yield escape(context.call(environment.getattr((undefined(name='parts') if l_0_parts is missing else l_0_parts), 'table'), l_1_table, (t_1(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'entries')) > 1), _loop_vars=_loop_vars))
        yield '\n'
    l_1_table = missing
    yield '</noscript>\n'
    template = environment.get_template('unknown.html', 'page.html')
    gen = template.root_render_func(template.new_context(context.get_all(), True, {'parts': l_0_parts}))
    try:
        for event in gen:
            yield event
    finally: gen.close()
    yield '</section>\n<section id="library" aria-label="Library">\n'
    template = environment.get_template('library.html', 'page.html')
    gen = template.root_render_func(template.new_context(context.get_all(), True, {'parts': l_0_parts}))
    try:
        for event in gen:
            yield event
    finally: gen.close()
    yield '</section>\n<footer id="foot">\n'
    for l_1_notice in environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'notices'):
        _loop_vars = {}
        pass
        yield '<p>'
        yield escape(l_1_notice)
        yield '</p>\n'
    l_1_notice = missing
    yield '<p>Made by launchlint '
    yield escape(environment.getattr((undefined(name='data') if l_0_data is missing else l_0_data), 'version'))
    yield '. Layout by elkjs, © Eclipse contributors, EPL-2.0.</p>\n</footer>\n<script type="application/json" id="launchlint-data">'
    yield escape(t_3((undefined(name='json') if l_0_json is missing else l_0_json)))
    yield '</script>\n'
    for (l_1_name, l_1_text) in context.call(environment.getattr((undefined(name='scripts') if l_0_scripts is missing else l_0_scripts), 'items')):
        _loop_vars = {}
        pass
        if (undefined(name='names') if l_0_names is missing else l_0_names):
            pass
            yield '<script src="'
            yield escape(t_4(environment.getitem((undefined(name='names') if l_0_names is missing else l_0_names), l_1_name)))
            yield '"></script>\n'
        else:
            pass
            yield '<script>'
            yield escape(t_3(l_1_text))
            yield '</script>\n'
    l_1_name = l_1_text = missing
    yield '</body>\n</html>\n'

blocks = {}
debug_info = '1=46&6=49&10=51&11=53&12=55&13=58&15=63&21=66&22=68&24=76&25=80&33=88&34=90&37=97&43=104&44=110&45=113&48=117&51=124&54=131&55=135&57=139&59=141&60=143&61=146&62=149&64=154'