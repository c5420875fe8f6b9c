// A shared object that is no solver.
int nothing_to_see();
int nothing_to_see() { return 0; }
