// Runs a piece of a test in a child process, where rights and limits can be taken away (POSIX).
#pragma once

#ifndef _WIN32
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <string>

namespace lt::test {

/// What `work` returns when it runs in a child process after `prepare`.
inline std::string in_child(const std::function<bool()>& prepare,
                            const std::function<std::string()>& work) {
  int ends[2];
  if (pipe(ends) != 0) return "(no pipe)";
  const pid_t child = fork();
  if (child == 0) {
    std::string result = "(the child could not be prepared)";
    try {
      if (prepare()) result = work();
    } catch (const std::exception& error) {
      result = std::string("(threw) ") + error.what();
    }
    const bool sent = write(ends[1], result.data(), result.size()) >= 0;
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  std::string result;
  char buffer[4096];
  for (ssize_t n = read(ends[0], buffer, sizeof buffer); n > 0;
       n = read(ends[0], buffer, sizeof buffer))
    result.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? result : "(the child died)";
}

/// As a user whom permissions bind: root is bound by none.
inline std::string as_ordinary_user(const std::function<std::string()>& work) {
  constexpr unsigned nobody = 65534;
  return in_child([] { return geteuid() != 0 || (setgid(nobody) == 0 && setuid(nobody) == 0); },
                  work);
}

/// Where no file may grow beyond `bytes`: for a program the same as a full disk.
inline std::string with_small_files(unsigned long bytes, const std::function<std::string()>& work) {
  return in_child(
      [bytes] {
        const rlimit limit{bytes, bytes};
        return std::signal(SIGXFSZ, SIG_IGN) != SIG_ERR && setrlimit(RLIMIT_FSIZE, &limit) == 0;
      },
      work);
}

}  // namespace lt::test
#endif
