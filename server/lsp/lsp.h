// server/lsp: the language server, for editors that speak the Language Server Protocol 3.17. `frames` cuts the bytes
// of the client into messages, `session` answers them, `texts` holds what is open, and each feature has a file that
// knows no JSON: diagnostics, hover, outline, definition, completion, rewriting. Every answer comes from what the
// commands and the page use: nothing about a language is decided here. Nothing here reads a file or waits: the command
// (server/cli) gives the bytes, the folders and the machines.
#pragma once

#include "server/lsp/frames.h"
#include "server/lsp/session.h"
#include "server/lsp/surroundings.h"
