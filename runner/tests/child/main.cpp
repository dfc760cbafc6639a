// What the tests of run_process run. The first word says what it does.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>

namespace {

void print_words(int argc, char** argv) {
  for (int i = 2; i < argc; ++i)
    std::cout << '<' << argv[i] << ">\n";
}

int count_input() {
  int count = 0;
  while (std::cin.get() != std::char_traits<char>::eof())
    ++count;
  return count;
}

[[noreturn]] void sleep() {
  std::cout << "sleeping" << std::endl;
  std::this_thread::sleep_for(std::chrono::seconds(60));
  std::exit(0);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string task = argc > 1 ? argv[1] : "";
  const std::string word = argc > 2 ? argv[2] : "";
  if (task == "words") print_words(argc, argv);
  if (task == "variable") std::cout << std::getenv(word.c_str());
  if (task == "input") std::cout << count_input();
  if (task == "both") (std::cout << "out\n" << std::flush, std::cerr << "err\n");
  if (task == "exit") return std::atoi(word.c_str());
  if (task == "crash") *static_cast<volatile int*>(nullptr) = 1;
  if (task == "sleep") sleep();
  if (task == "parent") return std::system(("\"" + std::string(argv[0]) + "\" sleep").c_str());
  return 0;
}
