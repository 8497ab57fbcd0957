#include "certify/program/signals.h"

#include <array>
#include <csignal>
#include <string_view>
#include <unistd.h>

#include "certify/numbers/ball.h"
#include "certify/program/output.h"

namespace epsnet::certify::program {
namespace {

/// The end for everything that cannot be caught: GMP and FLINT out of memory, std::terminate, a crash.
/// Async-signal-safe.
[[noreturn]] void end_on_signal(int) {
  constexpr std::string_view kText = "certify: internal fault\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kText.data(), kText.size());
  _exit(kExitInternal);
}

// FLINT's own spelling: for clang, a function type with this attribute differs from one with [[noreturn]].
FLINT_NORETURN void end_on_flint_abort() { end_on_signal(0); }

}  // namespace

void catch_signals() {
  // The handler has a stack of its own: the first one may be what has run out.
  alignas(16) static std::array<char, 1 << 16> handler_stack;
  stack_t stack{};
  stack.ss_sp = handler_stack.data();
  stack.ss_size = handler_stack.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = end_on_signal;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGABRT, SIGFPE, SIGSEGV, SIGBUS, SIGILL}) sigaction(signal, &action, nullptr);
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  flint_set_abort(end_on_flint_abort);
}

}  // namespace epsnet::certify::program
