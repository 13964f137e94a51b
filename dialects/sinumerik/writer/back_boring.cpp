// Oriented and shifted down to R, shifted back, bored upward, shifted again and out.
#include "dialects/sinumerik/writer/back_boring.h"

#include <vector>

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;

class Writer {
 public:
  Writer(const BackBoring& hole, ir::Program& program, passes::Rewrite& out)
      : hole_(hole), program_(program), out_(out) {}

  void write() {
    block(Function::spindle_orient, {});
    shift(1.0);
    block(Function::rapid, {to(hole_.level)});
    shift(-1.0);
    block(hole_.spindle, {});
    block(Function::linear, {to(hole_.depth)});
    if (hole_.dwell_s != ExpressionId::none) block(Function::dwell, {word(Address::f, hole_.dwell_s)});
    block(Function::spindle_orient, {});
    shift(1.0);
    block(Function::rapid, {to(hole_.initial)});
    shift(-1.0);
    block(hole_.spindle, {});
  }

 private:
  void block(Function function, const std::vector<ir::Word>& words) {
    ir::Code code;
    code.function = function;
    out_.emit_block({code}, words);
  }
  void shift(double sign) {
    std::vector<ir::Word> words;
    if (hole_.shift_x != ExpressionId::none) words.push_back(by(Address::x, hole_.shift_x, sign));
    if (hole_.shift_y != ExpressionId::none) words.push_back(by(Address::y, hole_.shift_y, sign));
    if (!words.empty()) block(Function::rapid, words);
  }
  // Numbers are in units of the program already.
  ir::Word to(ExpressionId level) {
    const ir::Expression e = program_.at(level);
    ir::Word w = word(Address::z, e.op == ir::Operator::constant ? program_.add_constant(e.value) : level);
    w.mode = ir::WordMode::absolute;
    return w;
  }
  ir::Word by(Address address, ExpressionId length, double sign) {
    const ir::Expression e = program_.at(length);
    ir::Word w = word(address, length);
    if (e.op == ir::Operator::constant)
      w.value = program_.add_constant(e.value * sign);
    else if (sign < 0.0)
      w.value = program_.add_operator(ir::Operator::negate, length);
    w.mode = ir::WordMode::incremental;
    return w;
  }

  const BackBoring& hole_;
  ir::Program& program_;
  passes::Rewrite& out_;
};

}  // namespace

void emit_back_boring(const BackBoring& hole, ir::Program& program, passes::Rewrite& out) {
  Writer(hole, program, out).write();
}

}  // namespace dripfeed::sinumerik
