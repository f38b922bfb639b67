// SPDX-License-Identifier: BSD-3-Clause
#include "SoakResult.h"

#include <iomanip>
#include <sstream>

namespace palpate::endurance
{
namespace
{
/// Duration of a run, s, from which each kind of disturbance is frequent enough to be required.
constexpr double LongEnough = 30.0;
/// s. The buffers that store the last 10 s of ticks fill up in this time, so the first quarter of
/// the run must be longer.
constexpr double WarmUp = 10.0;
/// Smallest fraction of ticks with a force. The other ticks are outside the body, in losses or
/// shortly after losses.
constexpr double FeltShare = 0.05;
/// Smallest fraction of the ticks with a force whose force differs enough from the previous tick's
/// force to detect an outdated force. There is no difference where samples are dropped or the force
/// is at its limit.
constexpr double StaleShare = 0.5;

template <class... Parts>
std::string text(const Parts&... parts)
{
  std::ostringstream line;
  (line << ... << parts);
  return line.str();
}

double share(std::uint64_t part, std::uint64_t whole)
{
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

std::string quoted(const std::string& line)
{
  std::string out = "\"";
  for (const char c : line)
  {
    if (c == '"' || c == '\\')
    {
      out += '\\';
    }
    out += c == '\n' ? ' ' : c;
  }
  return out + "\"";
}
} // namespace

std::vector<std::string> SoakResult::complaints() const
{
  std::vector<std::string> all;
  const auto must = [&all](bool holds, const std::string& otherwise)
  {
    if (!holds)
    {
      all.push_back(otherwise);
    }
  };
  must(this->tally.faults == 0, text(this->tally.faults, " ticks with a wrong force"));
  must(this->faults.empty() || this->tally.faults > 0, "something else went wrong, see above");
  must(this->ticks > 0 && this->tally.ticks == this->ticks,
    text(this->tally.ticks, " ticks checked of ", this->ticks));
  must(this->overruns == 0, text(this->overruns, " ticks that nobody saw"));
  must(this->swapsSeen == this->swapsAsked && this->swapsLate == 0,
    text(this->swapsAsked, " swaps asked for, ", this->swapsSeen, " seen, ", this->swapsLate,
      " of them not at once"));
  must(this->bodiesKept == 0 && this->bodiesAlive == 0,
    text(this->bodiesKept, " bodies not freed after their swap, ", this->bodiesAlive,
      " after the end"));
  must(!this->isForceLeft, "a force was left on the device");
  const bool isMemoryJudged = this->seconds >= 4.0 * WarmUp;
  must(!isMemoryJudged || this->resident.growth() <= MemoryWatch::ResidentAllowed,
    text("resident memory grew by ", this->resident.growth(), " MiB"));
  must(!isMemoryJudged || this->heap.growth() <= MemoryWatch::HeapAllowed,
    text("the heap in use grew by ", this->heap.growth(), " MiB"));
  must(share(this->tally.felt, this->ticks) >= FeltShare,
    text("only ", this->tally.felt, " ticks had a force: too few to tell"));
  must(share(this->tally.staleSeen, this->tally.felt) >= StaleShare,
    text("only in ", this->tally.staleSeen, " of ", this->tally.felt,
      " ticks a stale force would have shown"));
  must(!this->isDrawn || this->frames > 0, "no frame was drawn");
  const DeviceTroubles& t = this->troubles;
  must(this->seconds < LongEnough ||
      (t.unplugs > 0 && t.absent > 0 && t.notANumber > 0 && t.dropped > 0 && t.late > 0 &&
        t.hangs > 0 && this->swapsSeen > 0 && this->tally.silent > 0),
    "one of the troubles never came");
  return all;
}

void SoakResult::print(std::ostream& out) const
{
  const TickTally& t = this->tally;
  const auto percent = [](std::uint64_t part, std::uint64_t whole)
  { return text(std::setprecision(3), 100.0 * share(part, whole), " %"); };
  out << "Soak: " << this->seconds << " s at " << this->rate << " Hz; " << this->granted << "\n"
      << "  ticks       " << this->ticks << ", " << t.ticks << " checked, " << this->overruns
      << " unseen; " << this->missed << " missed by the machine\n"
      << "  force       in " << t.felt << " (" << percent(t.felt, this->ticks) << "), up to "
      << t.largestForce << " N, steps up to " << t.largestStep << " N; outside " << t.free
      << ", no sample " << t.lost << " (" << t.silent << " silent for too long), gate shut "
      << t.shut << "\n"
      << "  model       " << t.faults << " ticks off; differs by " << t.nearest
      << " of the tolerance at most; excess " << t.largestExcess << " N\n"
      << "  sharpness   in " << percent(t.staleSeen, t.felt)
      << " of these the force of the tick before would have been refused; "
      << percent(t.limited, t.felt) << " bounded from above only; " << percent(t.changing, t.felt)
      << " of two bodies\n"
      << "  relaxing    " << t.relaxing << " ticks of a body that relaxes, within bounds; "
      << t.visits << " visits, which got out " << t.largestGain << " of force times way at most\n"
      << "  swaps       " << this->swapsAsked << " asked, " << this->swapsSeen << " seen, "
      << this->swapsLate << " late; bodies not freed: " << this->bodiesKept << ", after the end "
      << this->bodiesAlive << "\n"
      << "  troubles    " << this->troubles.unplugs << " unplugs, " << this->troubles.absent
      << " readings without a device, " << this->troubles.notANumber << " NaN, "
      << this->troubles.dropped << " dropped or stalled, " << this->troubles.late
      << " late or repeated, " << this->troubles.hangs << " hangs\n"
      << "  frames      " << this->frames << "\n"
      << "  memory      resident " << this->resident.first << " to " << this->resident.last
      << " MiB, growth " << this->resident.growth() << "; heap " << this->heap.first << " to "
      << this->heap.last << " MiB, growth " << this->heap.growth() << "\n"
      << "  wake-up     median " << this->wakeUp[0] << " us, 99 % " << this->wakeUp[1]
      << " us, longest " << this->wakeUp[2] << " us\n";
  for (const std::string& fault : this->faults)
  {
    out << "  FAULT       " << fault << "\n";
  }
  for (const std::string& complaint : this->complaints())
  {
    out << "  FAILED      " << complaint << "\n";
  }
  out << (this->complaints().empty() ? "Passed.\n" : "Failed.\n");
}

void SoakResult::writeJson(std::ostream& out) const
{
  const TickTally& t = this->tally;
  out << std::setprecision(8);
  const char* separator = "\n    ";
  const auto figure = [&](const char* name, const auto& value)
  {
    out << separator << "\"" << name << "\": " << value;
    separator = ",\n    ";
  };
  out << "{\n  \"part\": \"soak\",\n  \"passed\": "
      << (this->complaints().empty() ? "true" : "false") << ",\n  \"figures\": {";
  figure("seconds", this->seconds);
  figure("rate_hz", this->rate);
  figure("granted", quoted(this->granted));
  figure("ticks", this->ticks);
  figure("ticks_checked", t.ticks);
  figure("ticks_unseen", this->overruns);
  figure("ticks_missed", this->missed);
  figure("ticks_with_force", t.felt);
  figure("ticks_with_two_bodies", t.changing);
  figure("ticks_bounded_only", t.limited);
  figure("ticks_where_stale_shows", t.staleSeen);
  figure("ticks_relaxing", t.relaxing);
  figure("visits_relaxing", t.visits);
  figure("largest_gain_relaxing", t.largestGain);
  figure("ticks_outside", t.free);
  figure("ticks_without_sample", t.lost);
  figure("ticks_silent_too_long", t.silent);
  figure("ticks_gate_shut", t.shut);
  figure("ticks_wrong", t.faults);
  figure("largest_force_N", t.largestForce);
  figure("largest_step_N", t.largestStep);
  figure("largest_excess_N", t.largestExcess);
  figure("largest_share_of_tolerance", t.nearest);
  figure("swaps_asked", this->swapsAsked);
  figure("swaps_seen", this->swapsSeen);
  figure("swaps_late", this->swapsLate);
  figure("bodies_not_freed", this->bodiesKept + this->bodiesAlive);
  figure("unplugs", this->troubles.unplugs);
  figure("readings_without_device", this->troubles.absent);
  figure("samples_nan", this->troubles.notANumber);
  figure("samples_dropped", this->troubles.dropped);
  figure("samples_late", this->troubles.late);
  figure("hangs", this->troubles.hangs);
  figure("frames", this->frames);
  figure("resident_start_MiB", this->resident.first);
  figure("resident_end_MiB", this->resident.last);
  figure("resident_growth_MiB", this->resident.growth());
  figure("heap_start_MiB", this->heap.first);
  figure("heap_end_MiB", this->heap.last);
  figure("heap_growth_MiB", this->heap.growth());
  figure("wakeup_median_us", this->wakeUp[0]);
  figure("wakeup_p99_us", this->wakeUp[1]);
  figure("wakeup_max_us", this->wakeUp[2]);
  out << "\n  }\n}\n";
}
} // namespace palpate::endurance
