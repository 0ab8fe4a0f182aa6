#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "demos/report_page/Json.h"

/// Numbers as compact text, for the page's script to read back (web/data.js).
namespace cutwater::page {

std::string base64(std::string_view bytes);

/// Blobs: {"type", "n", "data"} with the numbers' little-endian bytes in base64.
void blob32(Json& json, std::span<const double> numbers);         ///< "f32"
void blob64(Json& json, std::span<const double> numbers);         ///< "f64"
void blobOf(Json& json, std::span<const std::uint32_t> numbers);  ///< "u32"

/// A long column, number by number:
///     SeriesEncoder encoder(seriesScale(low, high, 0.0));
///     for (const double v : column) encoder.add(v);
///     encoder.write(json);  // {"n", "scale", "data"}
/// With whole numbers q_i = round(v_i / scale) it keeps d_i = q_i - 2 q_{i-1} + q_{i-2} as zigzag
/// LEB128 varints, deflated without a header: smooth motions take about half a byte each.
class SeriesEncoder {
 public:
  explicit SeriesEncoder(double scale);
  ~SeriesEncoder();
  SeriesEncoder(SeriesEncoder&&) noexcept;
  /// @param value  finite, and below 2^52 scales.
  void add(double value);
  /// Once, at the end.
  void write(Json& json);

 private:
  void flush(bool last);
  struct Stream;
  std::unique_ptr<Stream> stream_;
  double scale_;
  std::int64_t before_ = 0, beforeThat_ = 0;  // q_{i-1}, q_{i-2}
  std::size_t count_ = 0;
  std::string waiting_, packed_;
};

/// The largest power of ten whose rounding is within 1e-6 of the column's range, and at most
/// `most` (0: any); of a column that does not change, within nine digits of its value.
double seriesScale(double low, double high, double most);

}  // namespace cutwater::page
