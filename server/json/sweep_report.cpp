// A side without a bound is null: the parameter's range ends there.
#include "server/json/sweep_report.h"

#include "server/json/object_reader.h"

namespace dripfeed::json {

namespace {

Document trial_document(const sweep::Trial& trial) {
  return {{"passes", trial.passes}, {"check", trial.check}, {"text", trial.text}};
}

Document side_document(const sweep::Side& side) {
  if (!side.is_bounded) return nullptr;
  return {{"fails_at", side.fails_at}, {"check", side.check}, {"text", side.text}};
}

Document share_document(const sweep::Share& share) { return {{"tried", share.tried}, {"passed", share.passed}}; }

Document example_document(const sweep::Report& report) {
  if (!report.smallest_failure) return nullptr;
  const sweep::Example& example = *report.smallest_failure;
  Document document = trial_document(example.trial);
  document["values"] = Document::object();
  document["changed"] = Document::array();
  for (std::size_t i = 0; i < report.parameters.size(); ++i)
    document["values"][report.parameters[i].name] = example.values[i];
  for (const std::size_t i : example.changed) document["changed"].push_back(report.parameters[i].name);
  return document;
}

}  // namespace

std::string sweep_report(const sweep::Report& report) {
  Document parameters = Document::array();
  for (std::size_t i = 0; i < report.parameters.size(); ++i) {
    const sweep::Parameter& one = report.parameters[i];
    Document row = {
        {"name", one.name}, {"unit", one.unit}, {"low", one.low}, {"high", one.high}, {"standard", one.standard}};
    if (i < report.ranges.size()) {
      row["passes"] = {report.ranges[i].low.reach, report.ranges[i].high.reach};
      row["low_bound"] = side_document(report.ranges[i].low);
      row["high_bound"] = side_document(report.ranges[i].high);
    }
    parameters.push_back(std::move(row));
  }
  return dump({{"parameters", std::move(parameters)},
               {"standard", trial_document(report.standard)},
               {"corners", share_document(report.corners)},
               {"samples", share_document(report.samples)},
               {"smallest_failure", example_document(report)},
               {"trials", report.trials}}) +
         "\n";
}

}  // namespace dripfeed::json
