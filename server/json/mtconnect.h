// The four answers of an MTConnect agent (2.0) as XML: which machines there are and their data items, the newest
// values, the changes, and released programs as files. Read-only, as the standard is.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/application.h"
#include "server/app/out/observations.h"

namespace dripfeed::json {

// Of the agent, for the head of each answer.
struct MtconnectAgent {
  std::string sender;         // the computer
  std::string source;         // in front of a machine's name it is the device's uuid
  std::int64_t instance = 0;  // see Observations
  std::int64_t now_ms = 0;
};

// A released program for one machine.
struct MtconnectFile {
  store::Release release;
  std::string name;
  std::uint64_t bytes = 0;
  std::int64_t made_at_ms = 0;
  std::string href;
};

std::string mtconnect_devices(const MtconnectAgent& agent, std::span<const std::string> machines, std::size_t assets);
std::string mtconnect_streams(const MtconnectAgent& agent, const app::ObservationBatch& batch);
std::string mtconnect_assets(const MtconnectAgent& agent, std::span<const MtconnectFile> files);
// `code`: as the standard names it, "OUT_OF_RANGE".
std::string mtconnect_error(const MtconnectAgent& agent, std::string_view code, std::string_view text);

}  // namespace dripfeed::json
