#include "hydro/geometry/panelling/SectionStrands.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/panelling/SectionRow.h"

namespace cutwater {
namespace {

constexpr int kSamples = 160;  // to begin with
constexpr double kNarrowest =
    2.5e-8;  // of the extent: two samples this close are not divided further

constexpr double kApart = 1e-5;     // of the extent: strands this near go on from one another
constexpr double kThinnest = 1e-4;  // of the extent: a strand this short is the roughness of an end

struct Sample {
  double place = 0.0;
  std::vector<SectionCurve> curves;
};

bool startsOnWater(const SectionCurve& curve) { return curve.points.front().z() == 0.0; }

/// For each curve of `a` the one of `b` that continues it, or −1. Both ways nearest, within reach.
std::vector<int> continuations(const Sample& a, const Sample& b, double reach) {
  const auto nearest = [&](const SectionCurve& curve, const std::vector<SectionCurve>& among) {
    int best = -1;
    double least = reach;
    for (std::size_t i = 0; i < among.size(); ++i) {
      if (startsOnWater(curve) != startsOnWater(among[i])) continue;
      if (const double d = distanceBetween(curve, among[i]).greatest; d <= least) {
        least = d;
        best = static_cast<int>(i);
      }
    }
    return best;
  };
  std::vector<int> next;
  for (std::size_t i = 0; i < a.curves.size(); ++i) {
    const int j = nearest(a.curves[i], b.curves);
    const bool mutual =
        j >= 0 && nearest(b.curves[static_cast<std::size_t>(j)], a.curves) == static_cast<int>(i);
    next.push_back(mutual ? j : -1);
  }
  return next;
}

/// Adds samples between two until curves continue or the place of the jump is known.
class Sampler {
 public:
  Sampler(const SectionCutter& cutter, double reach)
      : cutter_(cutter), reach_(reach), narrowest_(kNarrowest * (cutter.high() - cutter.low())) {}

  std::vector<Sample> samples() {
    using Side = SectionCutter::Side;
    const double low = cutter_.low(), high = cutter_.high();
    all_.push_back({low, cutter_.curvesAt(low, Side::Above)});
    for (int i = 1; i < kSamples; ++i) {
      const double x = low + (high - low) * i / kSamples;
      add({x, cutter_.curvesAt(x, Side::Above)});
    }
    add({high, cutter_.curvesAt(high, Side::Below)});
    return std::move(all_);
  }

 private:
  void add(Sample next) {
    if (next.place - all_.back().place > narrowest_ && !continues(all_.back(), next)) {
      const double x = 0.5 * (all_.back().place + next.place);
      add({x, cutter_.curvesAt(x, SectionCutter::Side::Above)});
      add(std::move(next));
    } else {
      all_.push_back(std::move(next));
    }
  }
  bool continues(const Sample& a, const Sample& b) const {
    const std::vector<int> next = continuations(a, b, reach_);
    std::vector<bool> reached(b.curves.size(), false);
    for (std::size_t i = 0; i < a.curves.size(); ++i) {
      if (next[i] >= 0)
        reached[static_cast<std::size_t>(next[i])] = true;
      else if (a.curves[i].length() > reach_ / 3)
        return false;
    }
    for (std::size_t j = 0; j < b.curves.size(); ++j)
      if (!reached[j] && b.curves[j].length() > reach_ / 3) return false;
    return true;
  }
  const SectionCutter& cutter_;
  double reach_, narrowest_;
  std::vector<Sample> all_;
};

/// The section of a bow with a bulb is one curve, ahead of the stem only the bulb's: where one
/// strand ends and another begins along a part of its section, the shorter is the longer's guest.
void findGuests(std::vector<SectionStrand>& strands, double apart, double reach) {
  for (SectionStrand& aft : strands)
    for (SectionStrand& fore : strands) {
      if (&aft == &fore || std::abs(fore.place.front() - aft.place.back()) > apart) continue;
      const SectionCurve &a = aft.curves.back(), &f = fore.curves.front();
      if (std::min(a.length(), f.length()) < reach / 3) continue;
      if (a.length() >= f.length() && spanOn(a, f, reach).found()) {
        aft.end.guests.push_back(f);
        fore.start.hosted = true;
      } else if (a.length() < f.length() && spanOn(f, a, reach).found()) {
        fore.start.guests.push_back(a);
        aft.end.hosted = true;
      }
    }
}

}  // namespace

std::vector<SectionStrand> sectionStrands(const SectionCutter& cutter, double reach) {
  const std::vector<Sample> samples = Sampler(cutter, reach).samples();
  std::vector<SectionStrand> strands;
  std::vector<int> strandOf;  // of each curve of the sample before
  for (std::size_t k = 0; k < samples.size(); ++k) {
    std::vector<int> here(samples[k].curves.size(), -1);
    if (k > 0) {
      const std::vector<int> next = continuations(samples[k - 1], samples[k], reach);
      for (std::size_t i = 0; i < next.size(); ++i)
        if (next[i] >= 0) here[static_cast<std::size_t>(next[i])] = strandOf[i];
    }
    for (std::size_t j = 0; j < here.size(); ++j) {
      if (here[j] < 0) {
        here[j] = static_cast<int>(strands.size());
        strands.emplace_back();
      }
      SectionStrand& strand = strands[static_cast<std::size_t>(here[j])];
      strand.place.push_back(samples[k].place);
      strand.curves.push_back(samples[k].curves[j]);
    }
    strandOf = std::move(here);
  }
  const double extent = cutter.high() - cutter.low();
  std::erase_if(strands, [&](const SectionStrand& s) {
    return s.place.size() < 2 || s.place.back() - s.place.front() < kThinnest * extent ||
           std::all_of(s.curves.begin(), s.curves.end(),
                       [&](const SectionCurve& c) { return c.length() <= reach / 3; });
  });
  findGuests(strands, kApart * extent, reach);
  return strands;
}

}  // namespace cutwater
