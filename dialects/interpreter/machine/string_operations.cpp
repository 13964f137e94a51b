// Strings keep their registers' memory, so that a message in a loop does not allocate once it has grown.
#include "dialects/interpreter/machine/string_operations.h"

#include <algorithm>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/state/axis_names.h"
#include "dialects/ir/alarm_details.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using text::DiagnosticId;

// ASCII only: the names of controls have no other letters.
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr std::size_t kLongestText = 200;  // PGA, STRING
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

bool StringOperations::execute(const Instruction& i, const CompiledProgram& program) {
  if (i.op == Opcode::string_to_number) return to_number(i);
  if (i.op == Opcode::string_to_axis) return to_axis(i);
  if (i.op == Opcode::string_to_value) return to_value(i);
  if (i.op == Opcode::string_load_element) return load_element(i, program);
  if (i.op == Opcode::string_store_element) return store_element(i, program);
  if (i.op == Opcode::string_fit) return fit(i);
  if (i.op == Opcode::string_find) return find(i);
  if (i.op == Opcode::string_part) return part(i);
  if (i.op == Opcode::string_length) {
    const std::string& text = storage_.text(i.b);
    storage_.reg(i.a) = is_unknown(text) ? kVacant : static_cast<double>(text.size());
  } else if (i.op == Opcode::string_equal) {
    const std::string& a = storage_.text(i.b);
    const std::string& b = storage_.text(i.c);
    storage_.reg(i.a) = is_unknown(a) || is_unknown(b) ? kVacant : a == b ? 1.0 : 0.0;
  } else if (i.op == Opcode::string_is_number) {
    const std::string& text = storage_.text(i.b);
    storage_.reg(i.a) = is_unknown(text) ? kVacant : text::parse_number(text).has_value() ? 1.0 : 0.0;
  } else if (i.op == Opcode::axis_name) {
    storage_.string(i.a) = axis_name(shared_, storage_.reg(i.b));
  } else if (i.op == Opcode::string_copy) {
    storage_.string(i.a) = storage_.text(i.b);
  } else if (i.op == Opcode::string_join) {
    // The result may be one of the operands.
    scratch_ = storage_.text(i.b);
    scratch_ += storage_.text(i.c);
    if (scratch_.size() > kLongestText && unset_is_unknown_) return join_fails(i);
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
  if (is_vacant(value)) {
    if (unset_is_unknown_) to += kUnknownText;
    return;
  }
  if (type == ir::ValueType::character)
    to += static_cast<char>(static_cast<unsigned char>(value));
  else
    to += text::format_shortest(value == 0.0 ? 0.0 : value);
}

bool StringOperations::to_number(const Instruction& i) {
  if (is_unknown(storage_.text(i.b))) {
    storage_.reg(i.a) = kVacant;
    return true;
  }
  const auto value = text::parse_number(storage_.text(i.b));
  if (!value.has_value())
    return report_.fail(i, DiagnosticId::argument_out_of_domain, {"NUMBER", '"' + storage_.text(i.b) + '"'},
                        ir::kToNumber);
  storage_.reg(i.a) = *value;
  return true;
}

// Which axes the machine has is its own; a text that no axis can be called is an alarm.
bool StringOperations::to_axis(const Instruction& i) {
  const std::string& text = storage_.text(i.b);
  if (is_unknown(text)) {
    storage_.reg(i.a) = kVacant;
    return true;
  }
  const auto usual = [](char c) { return (upper(c) >= 'A' && upper(c) <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
  if (text.empty() || (text.front() >= '0' && text.front() <= '9') || !std::ranges::all_of(text, usual))
    return report_.fail(i, DiagnosticId::wrong_type, {'"' + text + '"', "STRING", "AXIS"}, ir::kToAxis);
  storage_.reg(i.a) = axis_number(shared_, text);
  return true;
}

// A text of one character is that CHAR, and a BOOL is whether there is any (PGA, "Type conversion").
bool StringOperations::to_value(const Instruction& i) {
  const std::string& text = storage_.text(i.b);
  const bool character = static_cast<ir::ValueType>(i.extra) == ir::ValueType::character;
  if (is_unknown(text)) {
    storage_.reg(i.a) = kVacant;
    return true;
  }
  if (character && text.size() != 1)
    return report_.fail(i, DiagnosticId::wrong_type, {'"' + text + '"', "STRING", "CHAR"}, ir::kToCharacter);
  storage_.reg(i.a) = character      ? static_cast<double>(static_cast<unsigned char>(text.front()))
                      : text.empty() ? 0.0
                                     : 1.0;
  return true;
}

bool StringOperations::load_element(const Instruction& i, const CompiledProgram& program) {
  if (access_.has_unknown_index(i.c)) {
    storage_.string(i.a) = kUnknownText;
    return true;
  }
  const auto element = access_.find_element(i, program, i.b, i.c);
  if (element.has_value()) storage_.string(i.a) = storage_.string_at(storage_.bases().string + *element);
  return element.has_value();
}

bool StringOperations::store_element(const Instruction& i, const CompiledProgram& program) {
  if (access_.has_unknown_index(i.b)) {
    const Array& a = program.arrays[i.a];
    for (std::uint32_t n = 0; n < a.dimension1 * a.dimension2 * a.dimension3; ++n)
      storage_.string_at(storage_.bases().string + a.first_slot + n) = kUnknownText;
    return true;
  }
  const auto element = access_.find_element(i, program, i.a, i.b);
  if (element.has_value()) storage_.string_at(storage_.bases().string + *element) = storage_.text(i.c);
  return element.has_value();
}

// INDEX, RINDEX: where the character is, counted from 0; MINDEX: the first of any of the characters. -1 for none.
bool StringOperations::find(const Instruction& i) {
  const std::string& text = storage_.text(i.b);
  const std::string& wanted = storage_.text(i.c);
  if (is_unknown(text) || is_unknown(wanted)) {
    storage_.reg(i.a) = kVacant;
    return true;
  }
  const auto op = static_cast<ir::Operator>(i.extra);
  const std::size_t at = op == ir::Operator::find_text        ? text.find(wanted.substr(0, 1))
                         : op == ir::Operator::find_text_last ? text.rfind(wanted.substr(0, 1))
                                                              : text.find_first_of(wanted);
  storage_.reg(i.a) = at == std::string::npos || wanted.empty() ? -1.0 : static_cast<double>(at);
  return true;
}

// SUBSTR(text, first, count): what of it lies in the text.
bool StringOperations::part(const Instruction& i) {
  const std::string& text = storage_.text(i.b);
  const double first = storage_.reg(i.c);
  const double count = storage_.reg(next_register(i.c));
  if (is_unknown(text) || is_vacant(first) || is_vacant(count)) {
    storage_.string(i.a) = kUnknownText;
    return true;
  }
  if (first < 0.0 || count < 0.0) return report_.fail(i, DiagnosticId::result_overflow);
  const auto from = static_cast<std::size_t>(std::min(first, static_cast<double>(text.size())));
  scratch_ = text.substr(from, static_cast<std::size_t>(std::min(count, static_cast<double>(text.size()))));
  storage_.string(i.a) = scratch_;
  return true;
}

// 14099 of a control that knows STRING variables; the texts of messages are longer nowhere.
bool StringOperations::join_fails(const Instruction& i) {
  if (is_unknown(scratch_)) {
    storage_.string(i.a) = kUnknownText;
    return true;
  }
  return report_.fail(i, DiagnosticId::string_too_long, {std::to_string(scratch_.size()), std::to_string(kLongestText)},
                      ir::kJoined);
}

bool StringOperations::fit(const Instruction& i) {
  const std::size_t size = storage_.text(i.b).size();
  if (size > i.c && !is_unknown(storage_.text(i.b)))
    return report_.fail(i, DiagnosticId::string_too_long, {std::to_string(size), std::to_string(i.c)});
  storage_.string(i.a) = storage_.text(i.b);
  return true;
}

}  // namespace dripfeed::interpreter
