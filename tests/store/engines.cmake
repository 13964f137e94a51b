# The tests of the store, once more on PostgreSQL: on a server of their own, which the tests start.
if(TARGET store_whole)
  file(GLOB folders /usr/lib/postgresql/*/bin)
  find_program(DRIPFEED_INITDB initdb HINTS ${folders} REQUIRED)
  find_program(DRIPFEED_POSTGRES postgres HINTS ${folders} REQUIRED)
  target_compile_definitions(store_whole PRIVATE
    DRIPFEED_INITDB="${DRIPFEED_INITDB}" DRIPFEED_POSTGRES="${DRIPFEED_POSTGRES}")
  # What is left out is about SQLite's file: its log, its copies, its old schemas, a disk that fails, a process that is
  # killed while it writes. The library of words is a file on both.
  set(about_a_file
    ArchiveTest.* CrashTest.* *FailTest.* LibraryTest.* SchemaTest.* SharedCrash.* VerifyTest.*
    Concurrency.ABackupIsOneStateWhileTheLedgerIsWritten OpenTest.AMissingFileIsMadeOnlyWhenAsked
    OpenTest.OtherFilesAreLeftAlone OpenTest.TheFileIsInWalMode OpenTest.ItsFilesAreForTheirOwnerAlone
    OpenTest.DamageIsFound Shared.ThoseWhoWaitTogetherShareOneCommit Shared.ACommitThatFailsFailsForAll)
  list(JOIN about_a_file ":" about_a_file)
  set_tests_properties(store_whole PROPERTIES ENVIRONMENT GTEST_FILTER=-Postgresql*)
  add_test(NAME store_whole_postgresql COMMAND store_whole --gtest_filter=-${about_a_file})
  set_tests_properties(store_whole_postgresql PROPERTIES
    ENVIRONMENT DRIPFEED_STORE_ENGINE=postgresql LABELS store TIMEOUT 600)
endif()
