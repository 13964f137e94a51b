// Lines of each control by chance; branches, loops and calls in its own forms.
#include "tests/unit/dialects/compile/facts_programs.h"

#include <fmt/format.h>

namespace dripfeed::compile::test {

std::string Generator::straight(std::size_t statements) {
  begin();
  for (std::size_t i = 0; i < statements; ++i) plain();
  end();
  return text_;
}
std::string Generator::branching(std::size_t statements) {
  begin();
  while (made_ < statements) piece(0);
  end();
  if (!spelling_.has_names)
    for (int program = 1; program <= 2; ++program) subprogram(program);
  return text_;
}
void Generator::line(std::string_view text) {
  text_ += text;
  text_ += '\n';
  ++made_;
}
void Generator::begin() {
  if (!spelling_.has_names) line("O1");
  if (below(2) == 0) line(spelling_.has_names ? "G90 G71 G17 G0" : "G21 G0");
}
void Generator::plain() {
  switch (below(4)) {
    case 0: return line(spelling_.snapshot);
    case 1: {
      std::string words(any(spelling_.axis_words));
      for (std::size_t at = words.find("{}"); at != std::string::npos; at = words.find("{}")) {
        const bool is_feed = at > 0 && words[at - 1] == 'F';
        words.replace(at, 2, is_feed ? std::to_string(below(90) + 10) : number());
      }
      if (below(3) == 0) words = std::string(below(2) == 0 ? "G1 " : "G0 ") + words;
      return line(words);
    }
    default: return line(any(spelling_.lines));
  }
}
std::string Generator::condition() {
  return spelling_.has_names ? fmt::format("R{}>{}", 1 + below(3), below(3))
                             : fmt::format("[#{} GT {}]", 101 + below(3), below(3));
}
void Generator::piece(int depth) {
  const int kind = depth > 2 ? 0 : below(10);
  if (kind == 7) return jump(depth);
  if (kind == 8) return loop(depth);
  if (kind == 9 && !spelling_.has_names && !in_subprogram_) return call();
  plain();
}
void Generator::body(int depth) {
  for (int i = below(5) + 1; i > 0; --i) piece(depth + 1);
}
void Generator::jump(int depth) {
  const int label = ++labels_;
  if (spelling_.has_names) {
    if (below(2) == 0) {
      line("IF " + condition());
      body(depth);
      if (below(2) == 0) {
        line("ELSE");
        body(depth);
      }
      return line("ENDIF");
    }
    line(fmt::format("IF {} GOTOF LAB{}", condition(), label));
    body(depth);
    return line(fmt::format("LAB{}:", label));
  }
  line(fmt::format("IF{}GOTO{}", condition(), 100 + label));
  body(depth);
  line(fmt::format("N{}", 100 + label));
}
void Generator::loop(int depth) {
  const int counter = 20 + depth + (in_subprogram_ ? 10 : 0);
  if (spelling_.has_names) {
    line(fmt::format("R{}=0", counter));
    line(fmt::format("WHILE R{}<R{}", counter, 1 + below(3)));
    body(depth);
    line(fmt::format("R{}=R{}+1", counter, counter));
    return line("ENDWHILE");
  }
  line(fmt::format("#{}=0", 100 + counter));
  line(fmt::format("WHILE[#{} LT #{}]DO{}", 100 + counter, 101 + below(3), depth + 1));
  body(depth);
  line(fmt::format("#{}=#{}+1", 100 + counter, 100 + counter));
  line(fmt::format("END{}", depth + 1));
}
void Generator::call() {
  const int program = 1001 + below(2);
  switch (below(5)) {
    case 0: return line(fmt::format("M98 P{} L2", program));
    case 1: return line(fmt::format("G65 P{}", program));
    case 2: return line(fmt::format("/M98 P{}", program));
    case 3:
      line(fmt::format("G66 P{}", program));
      for (int i = below(4); i >= 0; --i) plain();
      return line("G67");
    default: return line(fmt::format("M98 P{}", program));
  }
}
void Generator::subprogram(int number) {
  in_subprogram_ = true;
  line(fmt::format("O{}", 1000 + number));
  for (int i = below(6); i >= 0; --i) piece(1);
  line("M99");
}

}  // namespace dripfeed::compile::test
