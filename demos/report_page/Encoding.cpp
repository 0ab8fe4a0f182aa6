#include "demos/report_page/Encoding.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <new>
#include <vector>

namespace cutwater::page {

static_assert(std::endian::native == std::endian::little, "blobs are copied as they lie in memory");

namespace {

template <class Number>
void blob(Json& json, const char* type, std::span<const Number> numbers) {
  const std::string_view bytes(reinterpret_cast<const char*>(numbers.data()),
                               numbers.size() * sizeof(Number));
  json.beginObject().field("type", type).field("n", numbers.size());
  json.field("data", base64(bytes)).end();
}

}  // namespace

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t j) -> unsigned {
      return i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U;
    };
    const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
    text += kDigits[three >> 18];
    text += kDigits[three >> 12 & 63];
    text += i + 1 < bytes.size() ? kDigits[three >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? kDigits[three & 63] : '=';
  }
  return text;
}

void blob32(Json& json, std::span<const double> numbers) {
  std::vector<float> singles(numbers.size());
  std::transform(numbers.begin(), numbers.end(), singles.begin(),
                 [](double number) { return static_cast<float>(number); });
  blob<float>(json, "f32", singles);
}

void blob64(Json& json, std::span<const double> numbers) { blob(json, "f64", numbers); }

void blobOf(Json& json, std::span<const std::uint32_t> numbers) { blob(json, "u32", numbers); }

struct SeriesEncoder::Stream {
  z_stream z{};
  Stream() {
    if (deflateInit2(&z, 6, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Stream() { deflateEnd(&z); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
};

SeriesEncoder::SeriesEncoder(double scale) : stream_(std::make_unique<Stream>()), scale_(scale) {}
SeriesEncoder::~SeriesEncoder() = default;
SeriesEncoder::SeriesEncoder(SeriesEncoder&&) noexcept = default;

void SeriesEncoder::add(double value) {
  const auto q = static_cast<std::int64_t>(std::llround(value / scale_));
  const std::int64_t difference = q - 2 * before_ + beforeThat_;
  beforeThat_ = before_;
  before_ = q;
  ++count_;
  auto zigzag = static_cast<std::uint64_t>(difference) << 1;
  if (difference < 0) zigzag = ~zigzag;
  for (; zigzag > 127; zigzag >>= 7) waiting_ += static_cast<char>((zigzag & 127) | 128);
  waiting_ += static_cast<char>(zigzag);
  if (waiting_.size() >= 65536) flush(false);
}

void SeriesEncoder::flush(bool last) {
  z_stream& z = stream_->z;
  z.next_in = reinterpret_cast<Bytef*>(waiting_.data());
  z.avail_in = static_cast<uInt>(waiting_.size());
  char out[32768];
  do {
    z.next_out = reinterpret_cast<Bytef*>(out);
    z.avail_out = sizeof out;
    deflate(&z, last ? Z_FINISH : Z_NO_FLUSH);
    packed_.append(out, sizeof out - z.avail_out);
  } while (z.avail_out == 0);
  waiting_.clear();
}

void SeriesEncoder::write(Json& json) {
  flush(true);
  json.beginObject()
      .field("n", count_)
      .key("scale")
      .raw("1e" + std::to_string(static_cast<int>(std::lround(std::log10(scale_)))));
  json.field("data", base64(packed_)).end();
}

double seriesScale(double low, double high, double most) {
  constexpr double kShare = 2e-6;  // rounding is half a scale
  const double size = std::max(std::abs(low), std::abs(high));
  double wanted = high > low ? kShare * (high - low) : 1e-9 * size;
  wanted = std::max(wanted, 1e-15 * size);  // whole numbers stay below 2^52
  if (most > 0.0) wanted = std::min(wanted, most);
  return wanted > 0.0 ? std::pow(10.0, std::floor(std::log10(wanted) + 1e-9)) : 1.0;
}

}  // namespace cutwater::page
