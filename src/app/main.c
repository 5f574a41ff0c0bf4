#include <stdio.h>

int main(void)
{
    puts("murk 0.1.0");
    return 0;
}
