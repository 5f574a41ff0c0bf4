/* A run that ends between two renames: whose the files are is still known. */
#define _DEFAULT_SOURCE /* mkdtemp */
#include "check.h"
#include "results/json.h"
#include "results/results.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static char folder[] = "test_results.XXXXXX";

static size_t hidden(void)
{
    size_t n = 0;
    DIR *at = opendir(folder);
    for (const struct dirent *e; at && (e = readdir(at));) {
        n += e->d_name[0] == '.' && e->d_name[1] && e->d_name[1] != '.';
    }
    closedir(at);
    return n;
}

static const char *path_of(const char *name)
{
    static char path[64];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static bool holds(const char *name, const char *text)
{
    char *found = NULL;
    size_t size = 0;
    const bool is_same =
        !murk_file_read_own(&found, &size, path_of(name), 1000, NULL) &&
        strcmp(found, text) == 0;
    free(found);
    return is_same;
}

/* Two tables with this text, and the main JSON. */
static murk_status add_all(murk_results *results, const char *text,
                           murk_error *err)
{
    const murk_run_facts run = {.threads = 1};
    murk_status status = murk_results_add_text(results, "a.csv", text, err);
    if (!status) {
        status = murk_results_add_text(results, "b.csv", text, err);
    }
    cJSON *root = murk_json_begin_murk();
    murk_json_identify(root, text, results, "plan.json");
    char *json = murk_json_end(root, &run);
    if (!status) {
        status = murk_results_add_text(results, "plan.json", json, err);
    }
    cJSON_free(json);
    return status;
}

static murk_status write_all(const char *text, bool force)
{
    murk_results results;
    murk_status status = murk_results_begin(&results, folder, force, NULL);
    if (!status) {
        status = add_all(&results, text, NULL);
    }
    if (!status) {
        status = murk_results_show(&results, NULL);
    }
    murk_results_end(&results);
    return status;
}

/* As a kill between the renames of a.csv and b.csv leaves it: b.csv cannot be
 * replaced, as a folder stands there for a moment, and the process ends. */
static void be_killed(const char *text)
{
    char aside[80];
    snprintf(aside, sizeof aside, "%s/aside", folder);
    const pid_t pid = fork();
    if (pid == 0) {
        murk_results results;
        if (murk_results_begin(&results, folder, false, NULL) ||
            add_all(&results, text, NULL) ||
            rename(path_of("b.csv"), aside) != 0 ||
            mkdir(path_of("b.csv"), 0777) != 0) {
            _exit(1);
        }
        _exit(murk_results_show(&results, NULL) == MURK_RUN_FAILED ? 0 : 1);
    }
    int ended = 0;
    waitpid(pid, &ended, 0);
    CHECK(ended == 0);
    CHECK(rmdir(path_of("b.csv")) == 0 && rename(aside, path_of("b.csv")) == 0);
}

static void test_a_killed_run(void)
{
    CHECK(!write_all("one", false));
    CHECK(hidden() == 0);
    be_killed("two");
    CHECK(holds("a.csv", "two") && holds("b.csv", "one"));
    CHECK(hidden() == 1);
    CHECK(murk_owned_belonging(path_of("a.csv")) == MURK_OF_ANOTHER_RUN);
    CHECK(murk_owned_belonging(path_of("b.csv")) == MURK_LISTED);
    CHECK(murk_owned_belonging(path_of("c.csv")) == MURK_UNLISTED);
    be_killed("three"); /* and once more */
    CHECK(holds("a.csv", "three") && holds("b.csv", "one"));
    CHECK(!write_all("four", false));
    CHECK(holds("a.csv", "four") && holds("b.csv", "four"));
    CHECK(murk_owned_belonging(path_of("a.csv")) == MURK_LISTED);
    CHECK(hidden() == 0);
}

static void test_an_edited_file(void)
{
    CHECK(!murk_file_write(path_of("b.csv"), "mine", 4, NULL));
    CHECK(write_all("five", false) == MURK_BAD_VALUE);
    CHECK(holds("a.csv", "four") && holds("b.csv", "mine"));
    CHECK(hidden() == 0);
    CHECK(!write_all("six", true));
    CHECK(holds("b.csv", "six"));
}

/* Refused files keep all others from being shown, also where the caller goes
 * on as if they had not been asked for. */
static void test_a_refusal_that_is_not_heard(void)
{
    murk_results results;
    CHECK(!murk_file_write(path_of("b.csv"), "mine", 4, NULL));
    CHECK(!murk_results_begin(&results, folder, false, NULL));
    CHECK(murk_results_add_text(&results, "b.csv", "x", NULL) ==
          MURK_BAD_VALUE);
    CHECK(!murk_results_add_text(&results, "a.csv", "x", NULL));
    murk_error err = {0};
    CHECK(murk_results_show(&results, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.where, path_of("b.csv"));
    murk_results_end(&results);
    CHECK(holds("a.csv", "six") && holds("b.csv", "mine"));
}

static void test_sums_of_json(void)
{
    const murk_run_facts run = {.threads = 1}, other = {.threads = 2};
    char *a = murk_json_end(murk_json_begin_murk(), &run);
    char *b = murk_json_end(murk_json_begin_murk(), &other);
    char sum[65], again[65];
    murk_json_sum(sum, a);
    murk_json_sum(again, b);
    CHECK_TEXT(sum, again);
    CHECK(strstr(a, sum) != NULL);
    cJSON_free(a);
    cJSON_free(b);
}

int main(void)
{
    CHECK(mkdtemp(folder) != NULL);
    test_a_killed_run();
    test_an_edited_file();
    test_a_refusal_that_is_not_heard();
    test_sums_of_json();
    (void)unlink(path_of("a.csv"));
    (void)unlink(path_of("b.csv"));
    (void)unlink(path_of("plan.json"));
    CHECK(rmdir(folder) == 0);
    return check_failures != 0;
}
