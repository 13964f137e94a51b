-- Neovim as a person uses it, without a screen: opens a program that has an error, sees it, asks what a word means, follows a jump, mends what is
-- proposed, renumbers and leaves. DRIPFEED is the command, PROGRAM the file, CONFIG the lines of docs/editor.md; any failure ends it with a code.
local function fail(text)
  io.stderr:write(text .. '\n')
  vim.cmd('cquit 1')
end

local function expect(condition, text)
  if not condition then fail(text) end
end

local function wait_for(what, condition)
  expect(vim.wait(60000, condition, 50), 'waited in vain for ' .. what)
end

local function run()
  vim.env.PATH = vim.fn.fnamemodify(vim.env.DRIPFEED, ':h') .. ':' .. vim.env.PATH
  dofile(vim.env.CONFIG)
  vim.cmd('edit ' .. vim.env.PROGRAM)
  local buffer = vim.api.nvim_get_current_buf()
  wait_for('the server', function() return #vim.lsp.buf_get_clients(buffer) == 1 end)
  local client = vim.lsp.buf_get_clients(buffer)[next(vim.lsp.buf_get_clients(buffer))]
  expect(client.offset_encoding == 'utf-16', 'positions in ' .. client.offset_encoding)

  if vim.env.ENCODING ~= 'utf-8' then
    expect(vim.bo.fileencoding == 'latin1', 'the file is read as ' .. vim.bo.fileencoding)
    vim.lsp.buf.formatting_sync(nil, 60000)
    vim.cmd('write')
    return
  end
  wait_for('the diagnostic', function() return #vim.diagnostic.get(buffer, { severity = vim.diagnostic.severity.ERROR }) > 0 end)
  local fault = vim.diagnostic.get(buffer, { severity = vim.diagnostic.severity.ERROR })[1]
  expect(fault.code == 'homoglyph' and fault.lnum == 5, vim.inspect(fault))
  -- Columns of the editor are bytes: the comment before the fault has a character of two.
  local line = vim.api.nvim_buf_get_lines(buffer, fault.lnum, fault.lnum + 1, false)[1]
  expect(line:sub(fault.col + 1, fault.end_col) == 'М', 'the range holds "' .. line:sub(fault.col + 1, fault.end_col) .. '"')

  local function ask(method, line_number, column)
    vim.api.nvim_win_set_cursor(0, { line_number, column })
    local answers = vim.lsp.buf_request_sync(buffer, method, vim.lsp.util.make_position_params(0, client.offset_encoding), 60000)
    return answers[client.id].result
  end
  local hover = ask('textDocument/hover', 4, 3)
  expect(hover.contents.value:find('%*%*G01%*%* line'), vim.inspect(hover))

  vim.api.nvim_win_set_cursor(0, { 5, 12 })
  vim.lsp.buf.definition()
  wait_for('the jump to N3', function() return vim.api.nvim_win_get_cursor(0)[1] == 3 end)

  local actions = vim.lsp.buf_request_sync(buffer, 'textDocument/codeAction',
    { textDocument = { uri = vim.uri_from_bufnr(buffer) }, range = { start = { line = 5, character = 0 }, ['end'] = { line = 5, character = 20 } }, context = { diagnostics = {} } }, 60000)
  local quick = actions[client.id].result[1]
  expect(quick.kind == 'quickfix', vim.inspect(actions))
  vim.lsp.util.apply_workspace_edit(quick.edit, client.offset_encoding)
  wait_for('the fault to go', function() return #vim.diagnostic.get(buffer, { severity = vim.diagnostic.severity.ERROR }) == 0 end)

  vim.lsp.buf.formatting_sync(nil, 60000)
  local text = table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), '\n')
  expect(text == '%\nO1\nN10 G21 G90 G17 G94\nN20 G01 X1. F100.\nIF[#1GT2]GOTO10\n(Länge) M03\nM30\n%', text)
  vim.cmd('write')

  vim.lsp.stop_client(client.id)
  wait_for('the server to leave', function() return client.is_stopped() end)
end

local ok, why = xpcall(run, debug.traceback)
if not ok then fail(why) end
vim.cmd('qall!')
