#pragma once
#include <string>

/// The temporary files of this process, so that they can be removed from whatever place it ends at.
/// Safe to call from several threads.
namespace arelem::app {

void rememberTemporary(const std::string& path);
/// It has its final name now.
void forgetTemporary(const std::string& path);
void removeTemporary(const std::string& path);
void removeTemporaries();

}  // namespace arelem::app
