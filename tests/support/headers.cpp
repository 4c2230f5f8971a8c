// Empty: with it the headers that tests of the tools include are compiled once.
