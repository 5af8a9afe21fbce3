-- One session of Neovim with the server, in a workspace of tests/server/workspace.py; prints what came of it as JSON.
local root, out = vim.env.WORKSPACE, {}
local file = root .. '/demo/launch/main.launch'
local function finish()
  io.stdout:write(vim.json.encode(out) .. '\n')
  vim.cmd('qall!')
end
local ok, problem = pcall(function()
  loadstring(vim.env.SETTINGS)() -- those of docs/editors.md
  vim.cmd('edit ' .. vim.fn.fnameescape(file))
  local client = vim.g.launchlint
  vim.wait(60000, function() return #vim.diagnostic.get(0) >= 2 end, 50)
  out.diagnostics = vim.tbl_map(function(each) return each.code .. ':' .. each.lnum end, vim.diagnostic.get(0))
  local function request(method, line, character, more)
    local params = vim.tbl_extend('force', {
      textDocument = vim.lsp.util.make_text_document_params(0),
      position = { line = line, character = character },
    }, more or {})
    local answers, failed = vim.lsp.buf_request_sync(0, method, params, 60000)
    assert(answers, failed)
    assert(answers[client] and not answers[client].error, vim.inspect(answers))
    return answers[client].result
  end
  out.hover = request('textDocument/hover', 6, 37).contents.value
  local range = { start = { line = 2, character = 0 }, ['end'] = { line = 2, character = 30 } }
  local actions = request('textDocument/codeAction', 2, 0, { range = range, context = { diagnostics = {} } })
  vim.lsp.util.apply_workspace_edit(actions[1].edit, 'utf-16')
  vim.wait(60000, function() return #vim.diagnostic.get(0) == 1 end, 50)
  out.after_fix = vim.tbl_map(function(each) return each.code .. ':' .. each.lnum end, vim.diagnostic.get(0))
  local line = vim.fn.search('name="rate"') - 1
  vim.lsp.util.apply_workspace_edit(request('textDocument/rename', line, 15, { newName = 'hertz' }), 'utf-16')
  vim.cmd('wall')
  out.renamed = vim.fn.readfile(root .. '/demo/launch/part.launch')
  local last = vim.fn.line('$') - 1
  vim.fn.append(last, '  <node name="turtle" pkg="turtlesim" type="turtlesim_node"><remap from="turtle1/pose" to="')
  local offered = request('textDocument/completion', last, #vim.fn.getline(last + 1))
  out.completed = vim.tbl_map(function(each) return each.label end, offered.items)
end)
if not ok then
  out.problem = tostring(problem)
end
finish()
