#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <map>
#include <memory>
#include <system_error>

#include "common/error.hpp"
#include "runner/process.hpp"
#include "runner/windows_words.hpp"

namespace lt {

namespace {

using Clock = std::chrono::steady_clock;

std::atomic<bool> is_interrupted = false;

// Windows calls this in a thread of its own. When the console was closed it ends us as soon as this
// returns, and with us, by their jobs, what we have started.
BOOL WINAPI note_interrupt(DWORD) {
  is_interrupted = true;
  return TRUE;
}

struct Closer {
  void operator()(HANDLE handle) const { CloseHandle(handle); }
};
using Handle = std::unique_ptr<void, Closer>;

[[noreturn]] void fail(const std::string& what) {
  const auto error = static_cast<int>(GetLastError());
  throw OutputError(what + ": " + std::system_category().message(error));
}

// Holds a program and all that it starts: what is left of them ends when it is closed.
Handle make_job(bool is_limited) {
  Handle job(CreateJobObjectW(nullptr, nullptr));
  if (!job) fail("cannot make a job");
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  if (is_limited) {
    // After a crash no window asks what to do.
    limits.BasicLimitInformation.LimitFlags |=
        JOB_OBJECT_LIMIT_PROCESS_MEMORY | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
    limits.ProcessMemoryLimit = SIZE_T{4} << 30;
  }
  SetInformationJobObject(job.get(), JobObjectExtendedLimitInformation, &limits, sizeof limits);
  return job;
}

// The handles that a program inherits, and no others: another thread's pipe would never end.
class Inherited {
 public:
  Inherited(HANDLE input, HANDLE output) : handles_{input, output} {
    SIZE_T size = 0;
    InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
    bytes_.resize(size);
    if (!InitializeProcThreadAttributeList(list(), 1, 0, &size) ||
        !UpdateProcThreadAttribute(list(), 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, handles_,
                                   sizeof handles_, nullptr, nullptr)) {
      fail("cannot hand a pipe on");
    }
  }
  ~Inherited() { DeleteProcThreadAttributeList(list()); }
  Inherited(const Inherited&) = delete;
  Inherited& operator=(const Inherited&) = delete;
  [[nodiscard]] LPPROC_THREAD_ATTRIBUTE_LIST list() {
    return reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(bytes_.data());
  }

 private:
  HANDLE handles_[2];
  std::vector<char> bytes_;
};

// Starts the program in `job` and returns its handle, or none if it cannot be run.
Handle start(const std::vector<std::string>& command, const ProcessOptions& options,
             STARTUPINFOW& streams, DWORD flags, const Handle& job) {
  std::wstring line = command_line(command);
  std::wstring environment = environment_block(options.environment);
  const std::wstring folder = options.folder.wstring();
  PROCESS_INFORMATION started{};
  // It sleeps until it is in the job, so that nothing that it starts can escape.
  const BOOL is_started =
      CreateProcessW(find_program(command[0]).c_str(), line.data(), nullptr, nullptr, TRUE,
                     flags | CREATE_SUSPENDED | CREATE_UNICODE_ENVIRONMENT, environment.data(),
                     folder.empty() ? nullptr : folder.c_str(), &streams, &started);
  if (!is_started) return nullptr;
  Handle process(started.hProcess);
  const Handle thread(started.hThread);
  AssignProcessToJobObject(job.get(), process.get());
  ResumeThread(thread.get());
  return process;
}

// What is a signal elsewhere is an exit code here.
int signal_of(DWORD exit_code) {
  static const std::map<DWORD, int> signals{
      {0xC0000005, SIGSEGV},  // access violation
      {0xC00000FD, SIGSEGV},  // stack overflow
      {0xC0000094, SIGFPE},   // integer division by zero
      {0xC000001D, SIGILL},   // illegal instruction
      {0xC0000374, SIGABRT},  // damaged heap
      {0xC0000409, SIGABRT},  // fast fail, from abort()
      {0xC000013A, SIGINT},   // Ctrl-C
  };
  const auto found = signals.find(exit_code);
  return found == signals.end() ? 0 : found->second;
}

void wait_for(const Handle& process, ProcessResult& result) {
  constexpr int not_found = 127;
  DWORD exit_code = not_found;
  if (process) {
    WaitForSingleObject(process.get(), INFINITE);
    GetExitCodeProcess(process.get(), &exit_code);
  }
  result.signal = signal_of(exit_code);
  result.exit_code = result.signal == 0 ? static_cast<int>(exit_code) : 0;
}

// The program, and the end of a pipe that reads what it prints.
std::pair<Handle, Handle> start_with_pipe(const std::vector<std::string>& command,
                                          const ProcessOptions& options, const Handle& job) {
  SECURITY_ATTRIBUTES inheritable{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
  HANDLE ours = nullptr;
  HANDLE theirs = nullptr;
  if (!CreatePipe(&ours, &theirs, &inheritable, 0)) fail("cannot open a pipe");
  Handle reader(ours);
  const Handle writer(theirs);
  const Handle nothing(CreateFileW(L"NUL", GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_WRITE,
                                   &inheritable, OPEN_EXISTING, 0, nullptr));
  Inherited inherited(nothing.get(), writer.get());
  STARTUPINFOEXW streams{};
  streams.StartupInfo.cb = sizeof streams;
  streams.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
  streams.StartupInfo.hStdInput = nothing.get();
  streams.StartupInfo.hStdOutput = writer.get();
  streams.StartupInfo.hStdError = writer.get();
  streams.lpAttributeList = inherited.list();
  // In a group of its own Ctrl-C does not reach it: we stop it.
  constexpr DWORD flags = EXTENDED_STARTUPINFO_PRESENT | CREATE_NEW_PROCESS_GROUP;
  return {start(command, options, streams.StartupInfo, flags, job), std::move(reader)};
}

// Reads until the program has ended; false if the time is over or the person interrupted. What it
// left running in the background may still hold the pipe: that is not waited for.
bool read_output(HANDLE input, HANDLE process, const ProcessOptions& options,
                 Clock::time_point deadline, ProcessResult& result) {
  constexpr std::size_t limit = 4'000'000;
  std::vector<char> buffer(65536);
  while (!is_interrupted) {
    result.timed_out = options.seconds > 0 && Clock::now() > deadline;
    if (result.timed_out) return false;
    // In this order, or we could miss what it printed last.
    const bool has_ended = WaitForSingleObject(process, 0) == WAIT_OBJECT_0;
    DWORD size = 0;
    if (!PeekNamedPipe(input, nullptr, 0, nullptr, &size, nullptr)) return true;
    if (size == 0 && has_ended) return true;
    if (size == 0) {
      Sleep(5);
      continue;
    }
    if (!ReadFile(input, buffer.data(), 65536, &size, nullptr)) return true;
    const std::string_view piece(buffer.data(), size);
    result.output += piece.substr(0, limit - std::min(limit, result.output.size()));
    if (options.on_output) options.on_output(piece);
  }
  return false;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(options.seconds));
  const Handle job = make_job(options.is_limited);
  const auto [process, output] = start_with_pipe(command, options, job);
  ProcessResult result;
  if (process && !read_output(output.get(), process.get(), options, deadline, result)) {
    TerminateJobObject(job.get(), 1);
  }
  wait_for(process, result);
  std::erase(result.output, '\r');
  if (is_interrupted) throw Interrupted();
  return result;
}

ProcessResult run_visibly(const std::vector<std::string>& command, const ProcessOptions& options) {
  const Handle job = make_job(options.is_limited);
  STARTUPINFOW streams{};
  streams.cb = sizeof streams;
  ProcessResult result;
  wait_for(start(command, options, streams, 0, job), result);
  if (is_interrupted || result.signal == SIGINT) throw Interrupted();
  return result;
}

bool program_exists(const std::string& name) {
  return !find_program(name).empty();
}

void catch_interrupts() {
  SetConsoleCtrlHandler(note_interrupt, TRUE);
}

bool was_interrupted() {
  return is_interrupted.exchange(false);
}

FileLock::FileLock(const std::filesystem::path& path) {
  std::error_code ignored;
  std::filesystem::create_directories(path.parent_path(), ignored);
  const HANDLE file =
      CreateFileW(path.c_str(), GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                  nullptr, OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
  handle_ = reinterpret_cast<std::intptr_t>(file);
  OVERLAPPED start{};
  constexpr DWORD flags = LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY;
  while (!LockFileEx(file, flags, 0, 1, 0, &start) && GetLastError() == ERROR_LOCK_VIOLATION) {
    if (was_interrupted()) {
      CloseHandle(file);
      throw Interrupted();
    }
    Sleep(20);
  }
}

FileLock::~FileLock() {
  const auto file = reinterpret_cast<HANDLE>(handle_);
  if (file != INVALID_HANDLE_VALUE) CloseHandle(file);
}

}  // namespace lt
