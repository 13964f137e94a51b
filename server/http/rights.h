// What a caller may do on which machine, and what a token with a scope may change. The role that a route needs is a
// column of its row (see router.h); here is on which machine it acts, and what it belongs to.
#pragma once

#include <string_view>

#include "server/http/router.h"
#include "server/http/sessions.h"

namespace dripfeed::http {

// What a token may be limited to. Reading is always allowed as far as the role goes.
inline constexpr std::string_view kScopes[] = {
    "library",   // programs, families, parts, receipts
    "checks",    // renders, checks, measures, sweeps
    "releases",  // releases and waivers
    "queue",     // jobs before they are armed
    "line",      // arming, stopping, resuming, confirming, alarms
    "setup",     // machines, users, tokens and all else that is set up
};

// The scope that a change by this route belongs to.
std::string_view scope_of(const Route& route);
// Whether `scope` (words with blanks between) allows it. "" allows everything.
bool allows(std::string_view scope, const Route& route);
// The first word of `scope` that is none of kScopes; "" when there is none.
std::string_view unknown_scope(std::string_view scope);

// The highest right that the caller may have for calls of this route, whatever machine they act on.
Right reach(const Route& route, const Caller& caller);
// The right for this very call. Where the machine is not found it is the same as reach(): the handler says what is
// wrong with the request.
Right right_for(const Route& route, const Call& call, const Caller& caller);

}  // namespace dripfeed::http
