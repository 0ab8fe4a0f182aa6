#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cutwater {

/// The finished frequencies of a sweep, in a file beside the future database, so that a sweep that
/// was killed at any moment can continue from them. Each is appended by one write with a checksum;
/// an incomplete one at the end is cut off when the file is opened again. Numbers are kept bit by
/// bit: a resumed sweep has the same bits. One thread, and one program, at a time.
///
/// A journal of another ship or other settings is kept beside the new one as PATH.KEY, KEY its own
/// 16 hex digits; a sweep of that ship and those settings finds it there again.
class SweepJournal {
 public:
  /// Opens or makes the file.
  /// @param key  hash of all that the numbers depend on.
  /// @param size  how many numbers a frequency has.
  /// @throws HydroError FileNotWritable, also for a link and while another program has it open;
  ///         FileMalformed for a file that is no journal, which is left as it is.
  SweepJournal(const std::string& path, std::uint64_t key, std::size_t size);
  ~SweepJournal();
  SweepJournal(const SweepJournal&) = delete;
  SweepJournal& operator=(const SweepJournal&) = delete;

  /// Frequencies found in the file: index and numbers.
  const std::map<std::uint64_t, std::vector<double>>& found() const noexcept { return found_; }
  /// @pre numbers.size() is `size`.  @throws HydroError FileNotWritable.
  void append(std::uint64_t index, std::span<const double> numbers);

 private:
  void open();
  void makeWayFor(std::uint64_t key);
  void load(std::uint64_t key);
  void put(std::string_view bytes) const;
  [[noreturn]] void refuse(const char* why) const;

  std::string path_;
  std::size_t size_;
  int file_ = -1;
  std::map<std::uint64_t, std::vector<double>> found_;
};

}  // namespace cutwater
