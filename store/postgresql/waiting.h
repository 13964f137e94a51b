// The one place that waits for the answer to what was sent.
#pragma once

#include <functional>
#include <memory>

struct pg_conn;
struct pg_result;

namespace dripfeed::postgresql {

struct ResultDrop {
  void operator()(pg_result* result) const;
};
using ResultPtr = std::unique_ptr<pg_result, ResultDrop>;

// Before the first question: from then on a full socket does not hold up who sends.
void make_waitable(pg_conn* handle);

// The last result, as PQexec gives it, of what PQsend… took. `gives_up` is asked ten times a second while nothing
// comes; where it says so the connection is cut, and is broken from then on. Null: nothing was taken, or the connection
// broke.
ResultPtr wait_for_result(pg_conn* handle, bool is_taken, const std::function<bool()>& gives_up);

}  // namespace dripfeed::postgresql
