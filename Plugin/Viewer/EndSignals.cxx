// SPDX-License-Identifier: BSD-3-Clause
#include "EndSignals.h"

#include <csignal>
#include <initializer_list>

namespace palpate
{
namespace
{
volatile std::sig_atomic_t Came = 0;

void recordSignal(int /*signal*/)
{
  Came = 1;
}

/// Sets the handler for the three signals, except those that have been ignored since the start of
/// the process (nohup).
void handle(void (*handler)(int))
{
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN)
    {
      struct sigaction now = {};
      now.sa_handler = handler;
      now.sa_flags = SA_RESETHAND | SA_RESTART;
      sigaction(signal, &now, nullptr);
    }
  }
}
} // namespace

EndSignals::EndSignals()
{
  Came = 0;
  handle(recordSignal);
}

EndSignals::~EndSignals()
{
  handle(SIG_DFL);
}

bool EndSignals::any() const noexcept
{
  return Came != 0;
}
} // namespace palpate
