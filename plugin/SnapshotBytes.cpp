// Snapshots as bytes: magic, version, precision of Bullet, key of the layout, length of what
// follows, the fields, checksum of all before. Numbers are little-endian.
#include <algorithm>
#include <bit>
#include <concepts>
#include <string>
#include <type_traits>

#include "hydro/Errors.h"
#include "hydro/base/Fnv1a.h"
#include "plugin/Seaway.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr std::string_view kMagic = "CUTWSNAP";
constexpr std::uint32_t kVersion = 1;  // of all but the fields, which have the key of their layout
constexpr std::size_t kHeaderSize = 8 + 4 + 4 + 8 + 8, kChecksumSize = 8;

// Each field once, for writing, reading and describing. A new field is a new line here; it changes
// the key of the layout, so that bytes of another layout are refused.
template <class Visitor, class Record>
requires std::same_as<std::remove_const_t<Record>, TickRecord>
void visitFields(Visitor& v, Record& s) {
  v.field("time", s.time);
  v.field("position", s.position);
  v.field("attitude", s.attitude);
  v.field("velocity", s.velocity);
  v.field("loads", s.loads);
}

template <class Visitor, class Snapshot>
requires std::same_as<std::remove_const_t<Snapshot>, Ship::Snapshot>
void visitFields(Visitor& v, Snapshot& s) {
  v.field("transform", s.transform);
  v.field("interpolated", s.interpolated);
  v.field("velocities", s.velocities);
  v.field("past", s.past);
  v.field("pastAxes", s.pastAxes);
  v.field("pastBody", s.pastBody);
  v.field("carries", s.carries);
  v.field("before", s.before);
  v.field("lastStep", s.lastStep);
  v.field("stepBefore", s.stepBefore);
  v.field("courseBegins", s.courseBegins);
  v.field("anew", s.anew);
  v.field("activation", s.activation);
  v.field("now", s.now);
  v.field("lockedYaw", s.lockedYaw);
  v.field("known", s.known);
  v.field("record", s.record);
  v.field("course", s.course);
  v.field("line", s.line);
  v.field("predicted", s.predicted);
  v.field("immersed", s.immersed);
  v.field("hydrodynamicsKey", s.hydrodynamicsKey);
  v.field("partsKey", s.partsKey);
  v.field("sizes", s.sizes);
  v.field("states", s.states);
  v.field("enabled", s.enabled);
}

template <class Visitor, class Snapshot>
requires std::same_as<std::remove_const_t<Snapshot>, Float::Snapshot>
void visitFields(Visitor& v, Snapshot& s) {
  v.field("inWorld", s.inWorld);
  v.field("transform", s.transform);
  v.field("interpolated", s.interpolated);
  v.field("velocities", s.velocities);
  v.field("past", s.past);
  v.field("known", s.known);
  v.field("knownAt", s.knownAt);
  v.field("activation", s.activation);
  v.field("now", s.now);
  v.field("stillFor", s.stillFor);
  v.field("share", s.share);
  v.field("addedMass", s.addedMass);
  v.field("momentum", s.momentum);
  v.field("begun", s.begun);
}

template <class Visitor, class Snapshot>
requires std::same_as<std::remove_const_t<Snapshot>, Seaway::Snapshot>
void visitFields(Visitor& v, Snapshot& s) {
  v.field("time", s.time);
  v.field("seaKey", s.seaKey);
  v.field("calmLevel", s.calmLevel);
  v.field("ships", s.ships);
  v.field("floats", s.floats);
}

template <class T>
concept HasFields = std::same_as<T, TickRecord> || std::same_as<T, Ship::Snapshot> ||
    std::same_as<T, Float::Snapshot> || std::same_as<T, Seaway::Snapshot>;

template <class Visitor, class T>
void visit(Visitor& v, T& value);

template <class Visitor, class T>
void visitEach(Visitor& v, T& values, int count) {
  for (int i = 0; i < count; ++i) visit(v, values[i]);
}

template <class Visitor, class T, std::size_t n>
void visitArray(Visitor& v, std::array<T, n>& values) {
  for (T& value : values) visit(v, value);
}
template <class Visitor, class T, std::size_t n>
void visitArray(Visitor& v, const std::array<T, n>& values) {
  for (const T& value : values) visit(v, value);
}

// What a value is made of, down to numbers and sequences.
template <class Visitor, class T>
void visit(Visitor& v, T& value) {
  using Plain = std::remove_const_t<T>;
  if constexpr (HasFields<Plain>) {
    visitFields(v, value);
  } else if constexpr (std::is_arithmetic_v<Plain>) {
    v.number(value);
  } else if constexpr (std::same_as<Plain, btTransform>) {
    visit(v, value.getBasis());
    visit(v, value.getOrigin());
  } else if constexpr (std::same_as<Plain, btMatrix3x3> || std::same_as<Plain, btVector3>) {
    visitEach(v, value, 3);
  } else if constexpr (std::same_as<Plain, Vec3> || std::same_as<Plain, Vec6>) {
    visitEach(v, value, static_cast<int>(Plain::RowsAtCompileTime));
  } else if constexpr (std::same_as<Plain, Mat3>) {
    auto* numbers = value.data();
    visitEach(v, numbers, 9);
  } else if constexpr (requires { typename Plain::allocator_type; }) {
    v.sequence(value);
  } else {
    visitArray(v, value);
  }
}

// The names and kinds of all fields, and the least number of bytes they take.
class Layout {
 public:
  template <class T>
  void field(std::string_view name, T& value) {
    key_.add(name.data(), name.size());
    visit(*this, value);
  }
  template <class T>
  void number(const T&) {
    const char kind = std::same_as<T, btScalar>     ? 'r'
                      : std::is_floating_point_v<T> ? 'd'
                                                    : static_cast<char>('0' + sizeof(T));
    key_.add(&kind, 1);
    bytes_ += sizeof(T);
  }
  template <class T>
  void sequence(const std::vector<T>&) {
    T one{};
    Layout inner;
    visit(inner, one);
    const std::uint64_t key = inner.key_.value();
    key_.add(&key, sizeof key);
    bytes_ += sizeof(std::uint64_t);
  }
  std::uint64_t key() const noexcept { return key_.value(); }
  std::size_t bytes() const noexcept { return bytes_; }

  template <class T>
  static Layout of() {
    T one{};
    Layout layout;
    visit(layout, one);
    return layout;
  }

 private:
  Fnv1a key_;
  std::size_t bytes_ = 0;
};

template <std::size_t size>
using Bits = std::conditional_t<size == 8, std::uint64_t,
                                std::conditional_t<size == 4, std::uint32_t, std::uint8_t>>;

class Writer {
 public:
  template <class T>
  void field(std::string_view, const T& value) {
    visit(*this, value);
  }
  template <class T>
  void number(const T& value) {
    const auto bits = std::bit_cast<Bits<sizeof(T)>>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i)
      bytes_.push_back(static_cast<std::byte>((std::uint64_t{bits} >> (8 * i)) & 0xffu));
  }
  template <class T>
  void sequence(const std::vector<T>& values) {
    number(std::uint64_t{values.size()});
    for (const T& value : values) visit(*this, value);
  }
  void text(std::string_view text) {
    for (const char c : text) number(c);
  }
  std::vector<std::byte>& bytes() noexcept { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

[[noreturn]] void refuse(Fault fault, const std::string& what) {
  throw HydroError(fault, "Seaway::Snapshot::fromBytes: " + what);
}

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : left_(bytes) {}
  template <class T>
  void field(std::string_view, T& value) {
    visit(*this, value);
  }
  template <class T>
  void number(T& value) {
    if (left_.size() < sizeof(T)) refuse(Fault::FileMalformed, "the bytes end within a number");
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      bits |= std::to_integer<std::uint64_t>(left_[i]) << (8 * i);
    left_ = left_.subspan(sizeof(T));
    if constexpr (std::same_as<T, bool>) {
      if (bits > 1) refuse(Fault::FileMalformed, "a truth value is " + std::to_string(bits));
      value = bits == 1;
    } else {
      value = std::bit_cast<T>(static_cast<Bits<sizeof(T)>>(bits));
    }
  }
  // No more memory than a small multiple of the bytes that are there.
  template <class T>
  void sequence(std::vector<T>& values) {
    std::uint64_t count = 0;
    number(count);
    const std::size_t most = left_.size() / Layout::of<T>().bytes();
    if (count > most) {
      refuse(Fault::FileMalformed, std::to_string(count) + " numbers or ships are announced, for " +
                                       std::to_string(most) + " at most there are bytes");
    }
    values.resize(static_cast<std::size_t>(count));
    for (T& value : values) visit(*this, value);
  }
  template <class T>
  T next() {
    T value{};
    number(value);
    return value;
  }
  std::size_t left() const noexcept { return left_.size(); }

 private:
  std::span<const std::byte> left_;
};

std::uint64_t checksumOf(std::span<const std::byte> bytes) {
  Fnv1a sum;
  sum.add(bytes.data(), bytes.size());
  return sum.value();
}

std::string bits(std::size_t scalarSize) { return std::to_string(8 * scalarSize) + " bits"; }

// The fields of bytes whose frame is whole.
std::span<const std::byte> checkedFields(std::span<const std::byte> bytes) {
  const auto magic = std::as_bytes(std::span(kMagic));
  const std::size_t same = std::min(magic.size(), bytes.size());
  if (bytes.empty() || !std::ranges::equal(magic.first(same), bytes.first(same)))
    refuse(Fault::FileMalformed, "these bytes are no snapshot");
  if (bytes.size() < kHeaderSize + kChecksumSize)
    refuse(Fault::FileMalformed, "cut off after " + std::to_string(bytes.size()) + " bytes");
  Reader header(bytes.subspan(magic.size(), kHeaderSize - magic.size()));
  const auto version = header.next<std::uint32_t>(), scalar = header.next<std::uint32_t>();
  const auto key = header.next<std::uint64_t>(), length = header.next<std::uint64_t>();
  if (version != kVersion) {
    refuse(Fault::VersionNotSupported, "version " + std::to_string(version) + ", this reads " +
                                           std::to_string(kVersion) + "; save it anew");
  }
  const std::size_t there = bytes.size() - kHeaderSize - kChecksumSize;
  if (length != there) {
    refuse(Fault::FileMalformed, std::to_string(length) + " bytes of fields are announced, there " +
                                     "are " + std::to_string(there));
  }
  Reader end(bytes.last(kChecksumSize));
  if (end.next<std::uint64_t>() != checksumOf(bytes.first(kHeaderSize + there)))
    refuse(Fault::FileMalformed, "wrong checksum: the bytes were damaged");
  if (scalar != sizeof(btScalar)) {
    refuse(Fault::VersionNotSupported, "saved by Bullet with numbers of " + bits(scalar) +
                                           ", this one has " + bits(sizeof(btScalar)));
  }
  if (key != Layout::of<Seaway::Snapshot>().key()) {
    refuse(Fault::VersionNotSupported,
           "saved by another version of Cutwater, whose ships hold other numbers; save it anew");
  }
  return bytes.subspan(kHeaderSize, there);
}

void check(const Float::Snapshot& one) {
  constexpr int kLastOfFloat = 3;
  if (one.activation < ACTIVE_TAG || one.activation > DISABLE_SIMULATION || one.now < 0 ||
      one.now > kLastOfFloat)
    refuse(Fault::FileMalformed, "a float's activation is no word of Bullet's or of ours");
}

// What restore() takes as it is: sizes that it walks through, and numbers that stand for words.
void check(const Ship::Snapshot& ship) {
  constexpr int kLastWord = 2;  // of what a ship does in a tick
  if (ship.activation < ACTIVE_TAG || ship.activation > DISABLE_SIMULATION || ship.now < 0 ||
      ship.now > kLastWord)
    refuse(Fault::FileMalformed, "a ship's activation is no word of Bullet's or of ours");
  std::size_t left = ship.states.size();
  bool good =
      ship.enabled.size() == ship.sizes.size() && ship.record.loads.size() == ship.sizes.size();
  for (const std::size_t size : ship.sizes) {
    good = good && size <= left;
    if (good) left -= size;
  }
  if (!good || left != 0)
    refuse(Fault::FileMalformed, "the sizes of a ship's parts do not fit their numbers");
}

}  // namespace

std::vector<std::byte> Seaway::Snapshot::toBytes() const {
  Writer fields;
  visit(fields, *this);
  Writer all;
  all.text(kMagic);
  all.number(kVersion);
  all.number(static_cast<std::uint32_t>(sizeof(btScalar)));
  all.number(Layout::of<Seaway::Snapshot>().key());
  all.number(std::uint64_t{fields.bytes().size()});
  all.bytes().insert(all.bytes().end(), fields.bytes().begin(), fields.bytes().end());
  all.number(checksumOf(all.bytes()));
  return std::move(all.bytes());
}

Seaway::Snapshot Seaway::Snapshot::fromBytes(std::span<const std::byte> bytes) {
  Reader reader(checkedFields(bytes));
  Snapshot snapshot;
  visit(reader, snapshot);
  if (reader.left() != 0) {
    refuse(Fault::FileMalformed, std::to_string(reader.left()) + " bytes too many");
  }
  for (const Ship::Snapshot& ship : snapshot.ships) check(ship);
  for (const Float::Snapshot& one : snapshot.floats) check(one);
  return snapshot;
}

CUTWATER_PLUGIN_END
