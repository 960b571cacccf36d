// Where the compiler has no fuzzer: every file of the corpus, and a few thousand seeded mutations of each,
// through the same entry. A crash or an abort() is the failure.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr int kMutationsPerFile = 5'000;
using Bytes = std::vector<std::uint8_t>;

Bytes load(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class Mutator {
 public:
  explicit Mutator(const std::vector<Bytes>& corpus) : corpus_(corpus) {}

  Bytes mutate(Bytes bytes) {
    for (std::size_t steps = 1 + below(4); steps > 0; --steps) step(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_);
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(below(256)); }

  void step(Bytes& bytes) {
    const auto at = [&](std::size_t i) { return bytes.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t place = below(bytes.size() + 1);
    switch (below(5)) {
      case 0:
        if (place < bytes.size()) bytes[place] = static_cast<std::uint8_t>(bytes[place] ^ 1U << below(8));
        break;
      case 1:
        if (place < bytes.size()) bytes[place] = byte();
        break;
      case 2:
        bytes.insert(at(place), 1 + below(8), byte());
        break;
      case 3:
        bytes.erase(at(place), at(place + below(bytes.size() - place + 1)));
        break;
      default: {  // the rest of another one
        const Bytes& other = corpus_[below(corpus_.size())];
        bytes.erase(at(place), bytes.end());
        bytes.insert(bytes.end(), other.begin() + static_cast<std::ptrdiff_t>(below(other.size() + 1)),
                     other.end());
      }
    }
  }

  const std::vector<Bytes>& corpus_;
  std::mt19937_64 random_{20'260'101};
};

}  // namespace

int main(int argc, char** argv) {
  std::vector<Bytes> corpus;
  if (argc == 2) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[1]))
      corpus.push_back(load(entry.path()));
  }
  if (corpus.empty()) {
    std::cerr << "usage: " << argv[0] << " FOLDER with at least one file\n";
    return 2;
  }
  Mutator mutator(corpus);
  for (const Bytes& bytes : corpus) {
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    for (int i = 0; i < kMutationsPerFile; ++i) {
      const Bytes mutated = mutator.mutate(bytes);
      LLVMFuzzerTestOneInput(mutated.data(), mutated.size());
    }
  }
  std::cout << corpus.size() << " files, " << kMutationsPerFile << " mutations of each\n";
  return 0;
}
