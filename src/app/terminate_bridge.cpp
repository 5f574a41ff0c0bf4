/* Replaces the C++ runtime's terminate handler, which prints two lines and
 * aborts, by one that prints one line and exits with code 1.
 *
 * log4cplus, which OpenVDB links, starts threads of its own in a constructor of
 * the library, before main(). Where the machine refuses them (ulimit -u,
 * ulimit -v), std::thread throws there, and nothing can catch the exception. */
#include "app/terminate_bridge.h"

#include <exception>
#include <stdio.h>
#include <system_error>
#include <unistd.h>

namespace
{

[[noreturn]] void end_with_one_line()
{
    try {
        if (std::current_exception()) {
            throw;
        }
        dprintf(STDERR_FILENO, "murk: ended by a library\n");
    } catch (const std::system_error &error) {
        const bool is_refusal =
            error.code() == std::errc::resource_unavailable_try_again;
        dprintf(STDERR_FILENO, "murk: %s%s%s\n",
                is_refusal ? "cannot start a thread: " : "", error.what(),
                is_refusal ? " (ulimit -u, ulimit -v)" : "");
    } catch (const std::exception &error) {
        dprintf(STDERR_FILENO, "murk: %s\n", error.what());
    } catch (...) {
        dprintf(STDERR_FILENO, "murk: ended by a library\n");
    }
    _exit(1);
}

} // namespace

extern "C" void murk_terminate_install(void)
{
    std::set_terminate(end_with_one_line);
}
