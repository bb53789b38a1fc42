/* What a process has from whoever starts it, where the run-time system of Haskell does not look: see Inherited.hs. */
#ifndef DIOPTRE_INHERITED_H
#define DIOPTRE_INHERITED_H

#include <fcntl.h>
#include <signal.h>
#include <stddef.h>

/* Opens /dev/null in place of each standard stream that is closed. A file that is opened has the lowest number that is
   free, so without this the run-time system's own timer would be number 1 after `>&-`, and what is printed would go
   there. A constructor runs before main, and so before the timer is opened; nothing in Haskell runs that early. */
__attribute__((constructor)) static void dioptre_open_closed_streams(void) {
  for (int stream = 0; stream <= 2; stream++)
    if (fcntl(stream, F_GETFD) == -1)
      (void)open("/dev/null", O_RDWR);
}

/* Whether this signal is to be ignored, as under nohup. The package unix tells only what was set through it. */
static int dioptre_ignores(int number) {
  struct sigaction now;
  return sigaction(number, NULL, &now) == 0 && now.sa_handler == SIG_IGN;
}

#endif
