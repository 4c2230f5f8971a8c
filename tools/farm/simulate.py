#!/usr/bin/env python3
"""Says how long a plan takes on many machines, and what ends the gain of more.

usage: simulate.py PLAN.json [--workers N[,N...]] [--cache-mbit M] [--overhead SECONDS]

Workers take the units of `marrow cook --plan` from a queue, the longest first. Efficiency is what they would take if the
work could be cut anywhere, over what they take. `shards` is the same where the work is dealt out beforehand, as by --shard;
`split` where meshes learn for themselves first, by --fits. With --cache-mbit all results go into a cache over one
line of so many megabits a second; --overhead is what a unit costs beside cooking.
"""
import argparse
import heapq
import json


def deal(seconds, workers):
    """The longest first, each to who is free first: when the last is done."""
    free = [0.0] * workers
    for one in sorted(seconds, reverse=True):
        heapq.heapreplace(free, free[0] + one)
    return max(free)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument('plan')
    parser.add_argument('--workers', default='1,2,16,64,1000')
    parser.add_argument('--cache-mbit', type=float)
    parser.add_argument('--overhead', type=float, default=0.0)
    given = parser.parse_args()
    with open(given.plan, encoding='utf-8') as file:
        units = json.load(file)['units']
    whole = [unit['seconds'] + given.overhead for unit in units]
    fits = [fit['seconds'] + given.overhead for unit in units for fit in unit.get('fits', [])]
    rest = [max(unit['seconds'] - sum(fit['seconds'] for fit in unit.get('fits', [])), 0) + given.overhead for unit in units]
    sent = sum(sum(one['bytes'] for one in unit.get('inputs', [])) for unit in units) / 10  # files shrink to a tenth
    line = sent * 8 / (given.cache_mbit * 1e6) if given.cache_mbit else 0.0
    print(f'{len(units)} units, {sum(whole):.1f} s in all, the longest {max(whole):.2f} s')
    print('workers  seconds  efficiency  split: seconds  efficiency  ends by')
    for workers in map(int, given.workers.split(',')):
        perfect = sum(whole) / workers
        took = max(deal(whole, workers), line)
        split = max((deal(fits, workers) if fits else 0) + deal(rest, workers), line)
        ends = 'the line to the cache' if took == line else 'the longest unit' if took <= max(whole) * 1.001 else 'the work'
        print(f'{workers:7}  {took:7.2f}  {perfect / took:10.2f}  {split:14.2f}  {perfect / split:10.2f}  {ends}')


if __name__ == '__main__':
    main()
