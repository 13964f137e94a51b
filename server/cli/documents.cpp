// The only unit of the command that knows the JSON library.
#include "server/cli/documents.h"

#include <nlohmann/json.hpp>

namespace dripfeed::cli {

namespace {

using Document = nlohmann::ordered_json;

std::string dump(const Document& document) {
  return document.dump(-1, ' ', false, Document::error_handler_t::replace) + "\n";
}

}  // namespace

std::string run_document(const interpreter::RunResult& result) {
  Document variables = Document::object();
  for (const interpreter::VariableValue& variable : result.variables) {
    if (variable.text) {
      variables[variable.name] = *variable.text;
    } else {
      variables[variable.name] = variable.value ? Document(*variable.value) : Document(nullptr);
    }
  }
  Document skipped = Document::array();
  for (const interpreter::NotInterpreted& one : result.not_interpreted) {
    skipped.push_back({{"name", one.name},
                       {"line", one.first_line},
                       {"count", one.count},
                       {"effects_known", one.effects_known},
                       {"input", one.is_input}});
  }
  Document alarm = nullptr;
  if (result.ended != interpreter::Ended::end && !result.diagnostics.empty()) {
    const interpreter::RunDiagnostic& last = result.diagnostics.back();
    alarm = {{"line", last.line}, {"alarm", last.diagnostic.alarm}, {"text", text::message_of(last.diagnostic)}};
  }
  return dump({{"blocks", result.blocks},
               {"motions", result.motions},
               {"ended", interpreter::name_of(result.ended)},
               {"alarm", alarm},
               {"variables", variables},
               {"not_interpreted", skipped}});
}

std::string render_document(const compile::RenderResult& result) {
  return dump({{"text", result.text},
               {"mode", compile::name_of(result.mode)},
               {"because", result.because},
               {"blocks", result.blocks},
               {"bytes", result.bytes},
               {"variables", result.variables}});
}

std::string send_document(const app::LineReport& report, const WireHashes& hashes) {
  return dump({{"bytes", report.total},
               {"wire_sha256", hashes.wire_sha256},
               {"text_sha256", hashes.text_sha256},
               {"handed", report.handed},
               {"clocked", report.clocked},
               {"confirmed", report.confirmed},
               {"holds", report.holds},
               {"hold_s", report.hold_s},
               {"line_use", report.line_use},
               {"cause", report.cause},
               {"interval", {{"from", report.known.from}, {"to", report.known.to}}}});
}

std::string simulate_document(const simulator::ControlReport& report, const WireHashes& hashes) {
  Document histogram = Document::array();
  std::size_t used = report.after_dc3.size();
  while (used > 1 && report.after_dc3[used - 1] == 0) --used;
  for (std::size_t i = 0; i < used; ++i) histogram.push_back(report.after_dc3[i]);
  return dump({{"bytes", report.bytes},
               {"wire_sha256", hashes.wire_sha256},
               {"text_sha256", hashes.text_sha256},
               {"holds", report.holds},
               {"after_dc3_max", report.after_dc3_max},
               {"after_dc3_histogram", histogram},
               {"line_use", report.line_use},
               {"parity_errors", report.parity_errors},
               {"alarm", report.alarm.empty() ? Document(nullptr) : Document(report.alarm)},
               {"stalls", report.stalls},
               {"stall_s", report.stall_s},
               {"blocks_run", report.blocks_run},
               {"bytes_run", report.bytes_run},
               {"unfinished_block", report.unfinished_block},
               {"state", simulator::name_of(report.state)}});
}

}  // namespace dripfeed::cli
