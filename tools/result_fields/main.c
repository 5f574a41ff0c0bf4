/* Prints the fields of all result files as Markdown; the manual includes it. */
#include "results/catalogue.h"

int main(void)
{
    murk_results_catalogue(stdout);
    return fflush(stdout) != 0;
}
