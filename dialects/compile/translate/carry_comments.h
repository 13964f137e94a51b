// Comments of a program that is translated, put into the translation next to the lines that came from theirs. A comment
// says what the other control's comments can say and never becomes code there; framing lines (;$PATH=) are none.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/comment_style.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::compile {

// `printed` is the translation of `program` without its comments. Adds to `diagnostics` a note for each line whose
// comment has characters that `to` has no place for.
void carry_comments(const ir::Program& program, const ir::Control& to, CommentStyle style, ir::PrintResult& printed,
                    std::vector<text::Diagnostic>& diagnostics);

// Without its delimiters: "(ROUGH)" and "; rough" are "ROUGH" and "rough".
std::string_view text_of_comment(std::string_view comment);

}  // namespace dripfeed::compile
