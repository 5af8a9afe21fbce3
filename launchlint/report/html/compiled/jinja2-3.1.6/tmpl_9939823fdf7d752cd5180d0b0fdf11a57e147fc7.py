from jinja2.runtime import LoopContext, Macro, Markup, Namespace, TemplateNotFound, TemplateReference, TemplateRuntimeError, Undefined, escape, identity, internalcode, markup_join, missing, str_join
name = 'parts.html'

def root(context, missing=missing):
    resolve = context.resolve_or_missing
    undefined = environment.undefined
    concat = environment.concat
    cond_expr_undefined = Undefined
    if 0: yield None
    l_0_table = missing
    try:
        t_1 = environment.filters['length']
    except KeyError:
        @internalcode
        def t_1(*unused):
            raise TemplateRuntimeError("No filter named 'length' found.")
    pass
    def macro(l_1_table, l_1_several):
        t_2 = []
        if l_1_table is missing:
            l_1_table = undefined("parameter 'table' was not provided", name='table')
        if l_1_several is missing:
            l_1_several = undefined("parameter 'several' was not provided", name='several')
        pass
        t_2.extend((
            '<details class="table" open>\n<summary><h2>',
            escape(environment.getattr(l_1_table, 'caption')),
            ' <span class="number">',
            escape((environment.getattr(l_1_table, 'rows') + environment.getattr(l_1_table, 'more'))),
            '</span></h2></summary>\n',
        ))
        if environment.getattr(l_1_table, 'rows'):
            pass
            t_2.extend((
                '<div class="wide" tabindex="0" role="region" aria-label="',
                escape(environment.getattr(l_1_table, 'caption')),
                '">\n<table id="table-',
                escape(environment.getattr(l_1_table, 'id')),
                '">\n<thead><tr>',
            ))
            for l_2_column in environment.getattr(l_1_table, 'columns'):
                _loop_vars = {}
                pass
                t_2.extend((
                    '<th scope="col">',
                    escape(l_2_column),
                    '</th>',
                ))
            l_2_column = missing
            t_2.append(
                '</tr></thead>\n',
            )
            def t_3(fiter):
                for l_2_body in fiter:
                    if environment.getattr(l_2_body, 'rows'):
                        yield l_2_body
            for l_2_body in t_3(environment.getattr(l_1_table, 'bodies')):
                _loop_vars = {}
                pass
                t_2.extend((
                    '<tbody data-entry="',
                    escape(environment.getattr(l_2_body, 'entry')),
                    '">\n',
                ))
                if l_1_several:
                    pass
                    t_2.extend((
                        '<tr class="entry"><th colspan="',
                        escape(t_1(environment.getattr(l_1_table, 'columns'))),
                        '" scope="rowgroup">',
                        escape(environment.getattr(l_2_body, 'title')),
                        '</th></tr>\n',
                    ))
                for l_3_row in environment.getattr(l_2_body, 'rows'):
                    _loop_vars = {}
                    pass
                    t_2.extend((
                        '<tr data-index="',
                        escape(environment.getattr(l_3_row, 'number')),
                        '"',
                    ))
                    if environment.getattr(l_3_row, 'mark'):
                        pass
                        t_2.extend((
                            ' class="',
                            escape(environment.getattr(l_3_row, 'mark')),
                            '"',
                        ))
                    t_2.append(
                        '>',
                    )
                    for l_4_value in environment.getattr(l_3_row, 'cells'):
                        _loop_vars = {}
                        pass
                        t_2.extend((
                            '<td>',
                            escape(l_4_value),
                        ))
                    l_4_value = missing
                    t_2.append(
                        '\n',
                    )
                l_3_row = missing
                t_2.append(
                    '</tbody>\n',
                )
            l_2_body = missing
            t_2.append(
                '</table>\n</div>\n',
            )
            if environment.getattr(l_1_table, 'more'):
                pass
                t_2.extend((
                    '<p class="note">',
                    escape(environment.getattr(l_1_table, 'more')),
                    ' more rows belong to launch files that are not in this table: make a report of one file to see them here.</p>\n',
                ))
        else:
            pass
            t_2.extend((
                '<p class="empty">',
                escape(environment.getattr(l_1_table, 'empty')),
                '</p>\n',
            ))
        t_2.append(
            '</details>\n',
        )
        return concat(t_2)
    context.exported_vars.add('table')
    context.vars['table'] = l_0_table = Macro(environment, macro, 'table', ('table', 'several'), False, False, False, context.eval_ctx.autoescape)

blocks = {}
debug_info = '1=18&3=27&4=32&5=36&6=38&7=41&8=53&9=62&10=65&11=69&13=74&14=79&21=111&22=115&25=122'