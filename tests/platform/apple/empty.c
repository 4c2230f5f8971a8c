/* An executable without Marrow, for the size of what one has anyway. */
long road(void) {
  return 0;
}
