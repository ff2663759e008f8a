/* A cargo for programs under Wine: calls the Linux system's cargo, which compiles for Windows.
 * Arguments before "--" may be paths of Windows, which are rewritten for Linux; arguments after it
 * belong to the program that cargo runs. */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include <windows.h>
#include <shellapi.h>

/* Returns the arguments in UTF-8, whatever code page Windows has, and stores their count. */
static char **words_of(int *count)
{
    WCHAR **wide = CommandLineToArgvW(GetCommandLineW(), count);
    char **words = calloc(*count + 1, sizeof *words);
    for (int i = 0; i < *count; i++) {
        int length = WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, NULL, 0, NULL, NULL);
        words[i] = malloc(length);
        WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, words[i], length, NULL, NULL);
    }
    return words;
}

/* Rewrites a path on drive Z:, which is the root of the Linux system, for that; in place. */
static char *linux_path(char *word)
{
    if (word[0] != 'Z' || word[1] != ':') return word;
    for (char *letter = word; *letter; letter++)
        if (*letter == '\\') *letter = '/';
    return word + 2;
}

/* Copies a piece of output of the Linux process to a handle of Windows, which it does not reach
 * by itself. Forgets the source at its end. */
static void hand_on(struct pollfd *from, DWORD to)
{
    char piece[65536];
    DWORD written;
    if (!from->revents) return;
    ssize_t length = read(from->fd, piece, sizeof piece);
    if (length <= 0 || !WriteFile(GetStdHandle(to), piece, length, &written, NULL)) from->fd = -1;
}

int main(void)
{
    int output[2], errors[2], status, count;
    char **words = words_of(&count);
    words[0] = getenv("CARGO_BELOW");
    for (int i = 1; i < count && strcmp(words[i], "--"); i++) words[i] = linux_path(words[i]);
    if (!words[0] || pipe(output) || pipe(errors)) return 2;
    pid_t child = fork();
    if (child == 0) {
        dup2(output[1], 1);
        dup2(errors[1], 2);
        close(output[0]);
        close(errors[0]);
        execv(words[0], words);
        perror(words[0]);
        _exit(127);
    }
    close(output[1]);
    close(errors[1]);
    struct pollfd open[] = {{output[0], POLLIN}, {errors[0], POLLIN}};
    while (open[0].fd >= 0 || open[1].fd >= 0) {
        poll(open, 2, -1);
        hand_on(&open[0], STD_OUTPUT_HANDLE);
        hand_on(&open[1], STD_ERROR_HANDLE);
    }
    if (child < 0 || waitpid(child, &status, 0) < 0 || !WIFEXITED(status)) return 1;
    return WEXITSTATUS(status);
}
