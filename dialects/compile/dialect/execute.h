// Running a program of any dialect: what everything outside of dialects/ that wants motions calls. Brings the
// interpreter's result and the canonical trace along.
#pragma once

#include "dialects/compile/dialect/library.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/interpreter/machine/trace.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// `library`: of called programs; nullptr: none are found. Motions go to `sink` in batches, all of them before this
// returns.
interpreter::RunResult execute(const ir::Program& program, const ir::Control& control, ProgramLibrary* library,
                               ir::MotionSink& sink, const interpreter::RunOptions& options);

// Hands the same motions to several sinks, in order.
class FanOut final : public ir::MotionSink {
 public:
  explicit FanOut(std::vector<ir::MotionSink*> sinks) : sinks_(std::move(sinks)) {}
  void consume(std::span<const ir::Motion> motions) override {
    for (ir::MotionSink* sink : sinks_) sink->consume(motions);
  }

 private:
  std::vector<ir::MotionSink*> sinks_;
};

// Motions that no one wants.
class NoMotions final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion>) override {}
};

}  // namespace dripfeed::compile
