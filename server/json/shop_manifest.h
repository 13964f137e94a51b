// The manifest of an exported shop, and the report of an import.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "server/app/base/error.h"
#include "server/app/library/shop_files.h"

namespace dripfeed::json {

std::string write_manifest(const app::ShopManifest& manifest);
// Paths lead nowhere but down from the manifest's folder. Errors: malformed, invalid (each fault with its pointer).
app::Result<app::ShopManifest> read_manifest(std::string_view text);

// {"added","revised","same","skipped","failed","only_looked","items":[{"file","kind","outcome","why","why_said","name","folder",
// "dialect","program","revision","bytes","sha256"}]}
std::string import_report(std::span<const app::ImportRow> rows, bool only_looked);

}  // namespace dripfeed::json
