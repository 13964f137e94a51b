// Codes that neither move nor change what is modelled and have words of their own: G05.1 Q1, G08 P1, G61.1 P2. Those
// words are no words of a cycle that is in effect, and go where their code goes.
#pragma once

#include "dialects/ir/statement.h"

namespace dripfeed::ir {

constexpr bool idles(Function function, ModalGroup group) {
  return function == Function::no_effect && group == ModalGroup::non_modal;
}
constexpr bool is_word_of_idle_code(Address a) {
  return a == Address::p || a == Address::q || a == Address::l || a == Address::r;
}

}  // namespace dripfeed::ir
