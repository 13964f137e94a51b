// One line may be carried out often: each time it must lead to the same letter.
#include "dialects/compile/translate/cone_leads.h"

#include <cmath>
#include <span>

#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/dialect/try_out.h"
#include "dialects/ir/motion.h"

namespace dripfeed::compile {

namespace {

class ThreadWatch final : public ir::MotionSink {
 public:
  explicit ThreadWatch(bool x_is_diameter) : factor_(x_is_diameter ? 0.5 : 1.0) {}

  void consume(std::span<const ir::Motion> motions) override {
    for (const ir::Motion& motion : motions) {
      if (motion.kind != ir::MotionKind::thread) continue;
      const double x = factor_ * std::fabs(motion.end[0] - motion.start[0]);
      const double z = std::fabs(motion.end[2] - motion.start[2]);
      if (x == 0.0 || z == 0.0) continue;
      const ConeLead here = x > z ? ConeLead::along_x : ConeLead::along_z;
      const auto [row, is_new] = leads.try_emplace(motion.place.line, here);
      if (!is_new && row->second != here) row->second = ConeLead::either;
    }
  }

  std::map<std::uint32_t, ConeLead> leads;

 private:
  double factor_;
};

}  // namespace

std::map<std::uint32_t, ConeLead> cone_leads(const ir::Program& built, const ir::Control& control) {
  ThreadWatch watch(control.semantics.power_on_diameter == ir::DiameterMode::diameter);
  const bool ended = try_out(built, control, watch).ended == interpreter::Ended::end;
  for (auto& [line, lead] : watch.leads)
    if (!ended) lead = ConeLead::either;
  return std::move(watch.leads);
}

void name_cone_leads(ir::Program& raised, const std::map<std::uint32_t, ConeLead>& leads) {
  for (const ir::Statement& s : raised.statements) {
    const auto row = leads.find(s.line);
    if (s.kind != ir::StatementKind::block || row == leads.end()) continue;
    const ir::Block& block = raised.blocks[s.payload];
    for (std::uint32_t i = block.first_word; i < block.first_word + block.word_count; ++i) {
      ir::Address& address = raised.words[i].address;
      if (address != ir::Address::i && address != ir::Address::k) continue;
      address = row->second == ConeLead::along_x ? ir::Address::i : ir::Address::k;
    }
  }
}

}  // namespace dripfeed::compile
