// A library for LD_PRELOAD that makes one thing fail: ARELEM_FAULT = read-throws, disk-full:N (the
// N+1st byte written to a regular file), fsync, rename, malloc:N (the Nth allocation from main on,
// once).
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {
struct Fault {
  const char* name = nullptr;
  long number = 0;
};

Fault wanted() {
  const char* text = std::getenv("ARELEM_FAULT");
  if (text == nullptr) {
    return {"", 0};
  }
  const char* colon = std::strchr(text, ':');
  return {text, colon == nullptr ? 0 : std::atol(colon + 1)};
}

bool is(const char* name) {
  static const Fault fault = wanted();
  return std::strncmp(fault.name, name, std::strlen(name)) == 0;
}
long number() {
  static const long value = wanted().number;
  return value;
}

template <class Function>
Function original(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool regular(int fd) {
  struct stat status {};
  return fstat(fd, &status) == 0 && S_ISREG(status.st_mode);
}
}  // namespace

extern "C" ssize_t read(int fd, void* place, size_t size) {
  static const auto next = original<ssize_t (*)(int, void*, size_t)>("read");
  if (is("read-throws") && regular(fd)) {
    throw std::runtime_error("a fault on purpose");
  }
  return next(fd, place, size);
}

extern "C" ssize_t write(int fd, const void* bytes, size_t size) {
  static const auto next = original<ssize_t (*)(int, const void*, size_t)>("write");
  static long left = number();
  if (is("disk-full") && regular(fd)) {
    if (left <= 0) {
      errno = ENOSPC;
      return -1;
    }
    const size_t part = size < static_cast<size_t>(left) ? size : static_cast<size_t>(left);
    left -= static_cast<long>(part);
    return next(fd, bytes, part);
  }
  return next(fd, bytes, size);
}

extern "C" int fsync(int fd) {
  static const auto next = original<int (*)(int)>("fsync");
  if (is("fsync")) {
    errno = EIO;
    return -1;
  }
  return next(fd);
}

extern "C" int rename(const char* from, const char* to) noexcept {
  static const auto next = original<int (*)(const char*, const char*)>("rename");
  if (is("rename")) {
    errno = EACCES;
    return -1;
  }
  return next(from, to);
}

// operator new rather than malloc, and only from the first call of pthread_sigmask on, with which
// main begins: what libraries allocate before it can be caught by nobody.
static long allocations = 0;
static bool mainHasBegun = false;

extern "C" int pthread_sigmask(int how, const sigset_t* set, sigset_t* old) {
  static const auto next = original<int (*)(int, const sigset_t*, sigset_t*)>("pthread_sigmask");
  mainHasBegun = true;
  return next(how, set, old);
}

void* operator new(std::size_t size) {
  static const bool active = is("malloc:");
  if (active && mainHasBegun && ++allocations == number()) {
    throw std::bad_alloc();
  }
  void* place = std::malloc(size == 0 ? 1 : size);
  if (place == nullptr) {
    throw std::bad_alloc();
  }
  return place;
}
void operator delete(void* place) noexcept {
  std::free(place);
}
void operator delete(void* place, std::size_t) noexcept {
  std::free(place);
}
