// What dripfeed doctor looks at, one file a group. Nothing is opened that a control could notice, no lock is taken, and
// nothing is written: a server may run meanwhile.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "store/sqlite/state.h"

namespace dripfeed::cli {

enum class Health : std::uint8_t { ok, warning, fault };
std::string_view name_of(Health health);

struct Finding {
  Health health = Health::ok;
  std::string check;  // "disk", "port"
  std::string text;   // what is so
  std::string cure;   // what to do; "" where nothing is
};
using Findings = std::vector<Finding>;

// doctor_data.cpp. `state`: of the store, where it could be looked at.
void look_at_folder(const std::string& data, Findings& found);
void look_at_owner(const std::string& data, Findings& found);
void look_at_contents(const std::string& data, Findings& found, sqlite::StoreState& state);
// doctor_ports.cpp
void look_at_lines_folder(Findings& found);
void look_at_ports(const sqlite::StoreState& state, Findings& found);
// doctor_system.cpp
void look_at_clock(const sqlite::StoreState& state, Findings& found);
void look_at_limits(Findings& found);

}  // namespace dripfeed::cli
