// Strings keep their registers' memory, so that a message in a loop does not allocate once it has grown.
#include "dialects/interpreter/string_operations.h"

#include <algorithm>

#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using text::DiagnosticId;

// ASCII only: the names of controls have no other letters.
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

bool StringOperations::execute(const Instruction& i, const CompiledProgram& program) {
  if (i.op == Opcode::string_to_number) return to_number(i);
  if (i.op == Opcode::string_load_element) return load_element(i, program);
  if (i.op == Opcode::string_store_element) return store_element(i, program);
  if (i.op == Opcode::string_fit) return fit(i);
  if (i.op == Opcode::string_length) {
    storage_.reg(i.a) = static_cast<double>(storage_.text(i.b).size());
  } else if (i.op == Opcode::string_equal) {
    storage_.reg(i.a) = storage_.text(i.b) == storage_.text(i.c) ? 1.0 : 0.0;
  } else if (i.op == Opcode::string_copy) {
    storage_.string(i.a) = storage_.text(i.b);
  } else if (i.op == Opcode::string_join) {
    // The result may be one of the operands.
    scratch_ = storage_.text(i.b);
    scratch_ += storage_.text(i.c);
    storage_.string(i.a) = scratch_;
  } else if (i.op == Opcode::string_from_number) {
    scratch_.clear();
    append_number(scratch_, storage_.reg(i.b), static_cast<ir::ValueType>(i.extra));
    storage_.string(i.a) = scratch_;
  } else {
    std::string& to = storage_.string(i.a) = storage_.text(i.b);
    std::ranges::transform(to, to.begin(), i.op == Opcode::string_upper ? upper : lower);
  }
  return true;
}

// Reals as short as they can be read back, whole ones without a point; a CHAR is its character.
void StringOperations::append_number(std::string& to, double value, ir::ValueType type) {
  if (is_vacant(value)) return;
  if (type == ir::ValueType::character)
    to += static_cast<char>(static_cast<unsigned char>(value));
  else
    to += text::format_shortest(value == 0.0 ? 0.0 : value);
}

bool StringOperations::to_number(const Instruction& i) {
  const auto value = text::parse_number(storage_.text(i.b));
  if (!value.has_value())
    return report_.fail(i, DiagnosticId::argument_out_of_domain, {"NUMBER", '"' + storage_.text(i.b) + '"'});
  storage_.reg(i.a) = *value;
  return true;
}

bool StringOperations::load_element(const Instruction& i, const CompiledProgram& program) {
  const auto element = access_.find_element(i, program, i.b, i.c);
  if (element.has_value()) storage_.string(i.a) = storage_.string_at(storage_.bases().string + *element);
  return element.has_value();
}

bool StringOperations::store_element(const Instruction& i, const CompiledProgram& program) {
  const auto element = access_.find_element(i, program, i.a, i.b);
  if (element.has_value()) storage_.string_at(storage_.bases().string + *element) = storage_.text(i.c);
  return element.has_value();
}

bool StringOperations::fit(const Instruction& i) {
  if (storage_.text(i.b).size() > i.c) return report_.fail(i, DiagnosticId::result_overflow);
  storage_.string(i.a) = storage_.text(i.b);
  return true;
}

}  // namespace dripfeed::interpreter
