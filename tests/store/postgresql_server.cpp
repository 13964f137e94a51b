// initdb and postgres, as the user of Debian's package where the test is root: PostgreSQL refuses to be.
#include "tests/store/postgresql_server.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string_view>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <grp.h>
#include <libpq-fe.h>
#include <pwd.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dripfeed::store_test {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void give_up(const std::string& why) {
  fmt::print(stderr, "the tests need a PostgreSQL server (deploy/install test): {}\n", why);
  std::exit(2);
}

class Server {
 public:
  Server() {
    const fs::path memory = "/dev/shm";
    std::string name =
        ((fs::is_directory(memory) ? memory : fs::temp_directory_path()) / "dripfeed-postgresql-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) give_up("no temporary folder");
    folder_ = name;
    if (geteuid() == 0) become_ = getpwnam("postgres");
    if (geteuid() == 0 && become_ == nullptr) give_up("there is no user postgres");
    if (become_ != nullptr && chown(folder_.c_str(), become_->pw_uid, become_->pw_gid) != 0) give_up("chown");
    const int made = wait_for(start(
        {DRIPFEED_INITDB, "-D", data(), "-U", "tester", "-A", "trust", "--no-sync", "-E", "UTF8", "--locale=C.UTF-8"}));
    if (made != 0) give_up(fmt::format("initdb ended with {}", made));
    child_ = start({DRIPFEED_POSTGRES, "-D", data(), "-k", folder_, "-c", "listen_addresses=", "-c",
                    "max_connections=60", "-c", "autovacuum=off"});
    wait_until_it_answers();
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server() {
    kill(child_, SIGQUIT);
    wait_for(child_);
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  [[nodiscard]] std::string url_of(std::string_view database) const {
    return fmt::format("host={} user=tester dbname={}", folder_, database);
  }

 private:
  [[nodiscard]] std::string data() const { return folder_ + "/data"; }

  // SIGQUIT ends a server at once; it comes when this process ends, too.
  pid_t start(std::vector<std::string> words) const {
    const pid_t child = fork();
    if (child != 0) return child;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    if (become_ != nullptr && (initgroups(become_->pw_name, become_->pw_gid) != 0 || setgid(become_->pw_gid) != 0 ||
                               setuid(become_->pw_uid) != 0))
      _exit(126);
    prctl(PR_SET_PDEATHSIG, SIGQUIT);
    if (chdir(folder_.c_str()) != 0) _exit(126);
    const int log = open((folder_ + "/log").c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    execv(arguments.front(), arguments.data());
    _exit(127);
  }

  static int wait_for(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  void wait_until_it_answers() const {
    constexpr int kTries = 600;
    for (int i = 0; i < kTries; ++i) {
      if (PQping(url_of("postgres").c_str()) == PQPING_OK) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    give_up("it does not answer; " + folder_ + "/log says why");
  }

  std::string folder_;
  const passwd* become_ = nullptr;
  pid_t child_ = 0;
};

const Server& server() {
  static const Server started;
  return started;
}

}  // namespace

std::string database_url(const std::string& name) { return server().url_of(name); }

std::string run_sql(const std::string& database, const std::string& text) {
  const std::unique_ptr<PGconn, void (*)(PGconn*)> connection(PQconnectdb(database_url(database).c_str()), PQfinish);
  PQsetNoticeProcessor(connection.get(), [](void* /*to*/, const char* /*notice*/) {}, nullptr);
  const std::unique_ptr<PGresult, void (*)(PGresult*)> result(PQexec(connection.get(), text.c_str()), PQclear);
  const ExecStatusType status = PQresultStatus(result.get());
  if (status == PGRES_COMMAND_OK || status == PGRES_TUPLES_OK) return {};
  const char* const words = PQresultErrorField(result.get(), PG_DIAG_MESSAGE_PRIMARY);
  return words == nullptr ? PQerrorMessage(connection.get()) : words;
}

void make_database(const std::string& name, const std::string& copy_of) {
  const std::string fault = run_sql("postgres", fmt::format("CREATE DATABASE {} TEMPLATE {}", name, copy_of));
  if (!fault.empty()) give_up(fault);
}

void cut_connections(const std::string& database) {
  const std::string fault =
      run_sql("postgres",
              fmt::format("SELECT count(pg_terminate_backend(pid, 5000)) FROM pg_stat_activity WHERE datname = '{}'",
                          database));
  if (!fault.empty()) give_up(fault);
}

}  // namespace dripfeed::store_test
