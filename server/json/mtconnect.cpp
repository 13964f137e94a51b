// The documents of MTConnect, member by member.
#include "server/json/mtconnect.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "server/app/base/wall_time.h"
#include "server/json/xml.h"

namespace dripfeed::json {

namespace {

using app::DataItemRow;
using app::device_id;
using app::ItemCategory;
using app::Observation;

constexpr std::size_t kMostAssets = 1024;

struct Component {
  std::string_view where;    // as DataItemRow has it
  std::string_view element;  // in probe; in streams its name
  std::string_view id;       // after the device's
};
constexpr std::array kComponents = {Component{"", "Device", ""}, Component{"controller", "Controller", "_cont"},
                                    Component{"path", "Path", "_path"}};

std::string uuid_of(const MtconnectAgent& agent, std::string_view machine) {
  return fmt::format("{}/{}", agent.source, machine);
}

void open_document(Xml& xml, std::string_view kind) {
  const std::string urn = fmt::format("urn:mtconnect.org:MTConnect{}:2.0", kind);
  const std::string place = fmt::format("{} http://schemas.mtconnect.org/schemas/MTConnect{}_2.0.xsd", urn, kind);
  xml.open(fmt::format("MTConnect{}", kind),
           {{"xmlns", urn}, {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"}, {"xsi:schemaLocation", place}});
}

std::string number(std::uint64_t value) { return fmt::format("{}", value); }

void write_items(Xml& xml, const std::string& machine, std::string_view where) {
  xml.open("DataItems");
  for (const DataItemRow& row : app::data_items()) {
    if (row.where != where) continue;
    const std::string_view category = row.category == ItemCategory::event ? "EVENT" : "CONDITION";
    const std::string item = app::data_item_id(machine, row.item);
    if (row.sub_type.empty()) {
      xml.leaf("DataItem", {{"category", std::string(category)}, {"id", item}, {"type", std::string(row.type)}});
    } else {
      xml.leaf("DataItem", {{"category", std::string(category)},
                            {"id", item},
                            {"type", std::string(row.type)},
                            {"subType", std::string(row.sub_type)}});
    }
  }
  xml.close();
}

void write_device(Xml& xml, const MtconnectAgent& agent, const std::string& machine) {
  const std::string id = device_id(machine);
  xml.open("Device", {{"id", id}, {"name", machine}, {"uuid", uuid_of(agent, machine)}});
  write_items(xml, machine, "");
  xml.open("Components");
  xml.open("Controller", {{"id", id + "_cont"}, {"name", "controller"}});
  write_items(xml, machine, "controller");
  xml.open("Components");
  xml.open("Path", {{"id", id + "_path"}, {"name", "path"}});
  write_items(xml, machine, "path");
  for (int level = 0; level < 5; ++level) xml.close();
}

// "Unavailable" is the name of a condition's element as well as the word of an event.
void write_condition(Xml& xml, const Observation& one, const DataItemRow& row, const std::string& id) {
  const bool is_known = one.observed.value != app::kUnavailable;
  const std::string_view element = is_known ? std::string_view(one.observed.value) : "Unavailable";
  const std::string time = app::rfc3339(one.at_ms);
  const std::string type(row.type);
  if (one.observed.code.empty()) {
    xml.leaf(element, {{"dataItemId", id}, {"sequence", number(one.sequence)}, {"timestamp", time}, {"type", type}},
             one.observed.text);
  } else {
    xml.leaf(element,
             {{"dataItemId", id},
              {"sequence", number(one.sequence)},
              {"timestamp", time},
              {"type", type},
              {"nativeCode", one.observed.code}},
             one.observed.text);
  }
}

void write_event(Xml& xml, const Observation& one, const DataItemRow& row, const std::string& id) {
  const std::string time = app::rfc3339(one.at_ms);
  if (row.sub_type.empty()) {
    xml.leaf(row.element, {{"dataItemId", id}, {"sequence", number(one.sequence)}, {"timestamp", time}},
             one.observed.value);
  } else {
    xml.leaf(row.element,
             {{"dataItemId", id},
              {"sequence", number(one.sequence)},
              {"timestamp", time},
              {"subType", std::string(row.sub_type)}},
             one.observed.value);
  }
}

using OfMachine = std::vector<const Observation*>;

void write_component(Xml& xml, const std::string& id, const Component& component, const OfMachine& observations) {
  const auto items = app::data_items();
  const auto is_here = [&](const Observation* one, ItemCategory category) {
    const DataItemRow& row = items[static_cast<std::size_t>(one->item)];
    return row.where == component.where && row.category == category;
  };
  const auto any = [&](ItemCategory category) {
    return std::ranges::any_of(observations, [&](const Observation* one) { return is_here(one, category); });
  };
  if (!any(ItemCategory::event) && !any(ItemCategory::condition)) return;
  xml.open("ComponentStream",
           {{"component", std::string(component.element)}, {"componentId", id + std::string(component.id)}});
  for (const ItemCategory category : {ItemCategory::event, ItemCategory::condition}) {
    if (!any(category)) continue;
    xml.open(category == ItemCategory::event ? "Events" : "Condition");
    for (const Observation* const one : observations) {
      if (!is_here(one, category)) continue;
      const DataItemRow& row = items[static_cast<std::size_t>(one->item)];
      const auto write = category == ItemCategory::event ? write_event : write_condition;
      write(xml, *one, row, app::data_item_id(one->machine, row.item));
    }
    xml.close();
  }
  xml.close();
}

void write_file(Xml& xml, const MtconnectAgent& agent, const MtconnectFile& file) {
  const store::Release& release = file.release;
  const bool is_approved = release.state == store::ReleaseState::approved;
  xml.open("File", {{"assetId", fmt::format("release-{}", release.id)},
                    {"timestamp", app::rfc3339(release.changed_at_ms)},
                    {"deviceUuid", uuid_of(agent, release.of.machine)},
                    {"name", file.name},
                    {"mediaType", "text/plain"},
                    {"applicationCategory", "PROCESS"},
                    {"applicationType", "PRODUCTION_PROGRAM"},
                    {"size", number(file.bytes)},
                    {"versionId", number(release.of.revision)},
                    {"state", is_approved ? "PRODUCTION" : "EXPERIMENTAL"}});
  xml.leaf("FileLocation", {{"href", file.href}});
  xml.leaf("Signature", {}, release.text_sha256);
  xml.leaf("CreationTime", {}, app::rfc3339(file.made_at_ms));
  xml.close();
}

}  // namespace

std::string mtconnect_devices(const MtconnectAgent& agent, std::span<const std::string> machines, std::size_t assets) {
  Xml xml;
  open_document(xml, "Devices");
  xml.leaf("Header", {{"version", "2.0.0.0"},
                      {"creationTime", app::rfc3339(agent.now_ms)},
                      {"instanceId", fmt::format("{}", agent.instance)},
                      {"sender", agent.sender},
                      {"bufferSize", number(app::Observations::kKept)},
                      {"assetBufferSize", number(kMostAssets)},
                      {"assetCount", number(assets)},
                      {"deviceModelChangeTime", app::rfc3339(agent.instance * 1000)}});
  xml.open("Devices");
  for (const std::string& machine : machines) write_device(xml, agent, machine);
  return xml.take();
}

std::string mtconnect_streams(const MtconnectAgent& agent, const app::ObservationBatch& batch) {
  std::map<std::string_view, OfMachine> by_machine;
  for (const Observation& one : batch.observations) by_machine[one.machine].push_back(&one);
  Xml xml;
  open_document(xml, "Streams");
  xml.leaf("Header", {{"version", "2.0.0.0"},
                      {"creationTime", app::rfc3339(agent.now_ms)},
                      {"instanceId", fmt::format("{}", agent.instance)},
                      {"sender", agent.sender},
                      {"bufferSize", number(app::Observations::kKept)},
                      {"nextSequence", number(batch.next)},
                      {"firstSequence", number(batch.first)},
                      {"lastSequence", number(batch.last)},
                      {"deviceModelChangeTime", app::rfc3339(agent.instance * 1000)}});
  xml.open("Streams");
  for (const auto& [machine, observations] : by_machine) {
    xml.open("DeviceStream", {{"name", std::string(machine)}, {"uuid", uuid_of(agent, machine)}});
    for (const Component& component : kComponents) write_component(xml, device_id(machine), component, observations);
    xml.close();
  }
  return xml.take();
}

std::string mtconnect_assets(const MtconnectAgent& agent, std::span<const MtconnectFile> files) {
  Xml xml;
  open_document(xml, "Assets");
  xml.leaf("Header", {{"version", "2.0.0.0"},
                      {"creationTime", app::rfc3339(agent.now_ms)},
                      {"instanceId", fmt::format("{}", agent.instance)},
                      {"sender", agent.sender},
                      {"assetBufferSize", number(kMostAssets)},
                      {"assetCount", number(files.size())},
                      {"deviceModelChangeTime", app::rfc3339(agent.instance * 1000)}});
  xml.open("Assets");
  for (const MtconnectFile& file : files) write_file(xml, agent, file);
  return xml.take();
}

std::string mtconnect_error(const MtconnectAgent& agent, std::string_view code, std::string_view text) {
  Xml xml;
  open_document(xml, "Error");
  xml.leaf("Header", {{"version", "2.0.0.0"},
                      {"creationTime", app::rfc3339(agent.now_ms)},
                      {"instanceId", fmt::format("{}", agent.instance)},
                      {"sender", agent.sender},
                      {"bufferSize", number(app::Observations::kKept)}});
  xml.open("Errors");
  xml.leaf("Error", {{"errorCode", std::string(code)}}, text);
  return xml.take();
}

}  // namespace dripfeed::json
