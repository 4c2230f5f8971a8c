"""A cache over HTTP: nginx as it is, and servers that are absent, slow, full or lie."""
import contextlib
import os
import time

from common import empty, expect_same, files_of, free_port, liar, make_models, nginx, run

PUTS = 'dav_methods PUT; create_full_put_path on;'


class Models:
    def __init__(self, t, count=6):
        self.folder = empty(t.work / 'cache')
        self.marrow = t.marrow
        make_models(self.folder / 'in', count)
        run(t.marrow, 'cook', self.folder / 'in', '-o', self.folder / 'want')
        self.count = count

    def cook(self, *more, code=0):
        """How many came from the cache, and what was said; the output is what it is without a cache."""
        empty(self.folder / 'out')
        done = run(self.marrow, 'cook', self.folder / 'in', '-o', self.folder / 'out', *more, code=code)
        expect_same(self.folder / 'want', self.folder / 'out')
        return int(done.stdout.split(' from the cache')[0].split()[-1]), done.stderr


def on_nginx(t):
    models = Models(t)
    with nginx(models.folder / 'nginx', PUTS) as address:
        assert models.cook('--cache', address) == (0, '')
        assert models.cook('--cache', address) == (models.count, '')
        names = files_of(models.folder / 'nginx/files')
        assert len(names) == 2 * models.count and all(len(name) == len('ac/') + 64 for name in names), names[:3]
        # A folder before it is filled from it, and then asked alone.
        local = empty(models.folder / 'local')
        assert models.cook('--cache', local, '--cache', address) == (models.count, '')
    assert models.cook('--cache', local) == (models.count, '')
    return f'{models.count} models, {2 * models.count} entries'


def a_prefix_and_a_token(t):
    models = Models(t)
    token = models.folder / 'token'
    token.write_text('s3cret\n')
    guard = 'if ($http_authorization != "Bearer s3cret") { return 401; }'
    with nginx(models.folder / 'nginx', f'location /team/ {{ {PUTS} {guard} }}') as address:
        place = f'{address}/team/'
        count, said = models.cook('--cache', place)
        assert count == 0 and said.count('warning') == 1 and 'it answers 401; it is not asked any more' in said, said
        assert models.cook('--cache', place, '--cache-token', token) == (0, '')
        assert models.cook('--cache', place, '--cache-token', token) == (models.count, '')
        count, said = models.cook('--cache', address.replace('://', '://me:hidden@') + '/nowhere')
        assert count == 0 and 'hidden' not in said, said
    token.write_text('two words\n')
    run(t.marrow, 'cook', models.folder / 'in', '-o', models.folder / 'out', '--cache', place, '--cache-token', token, code=3)


def only_read(t):
    models = Models(t)
    with nginx(models.folder / 'nginx', PUTS) as address:
        assert models.cook('--cache', address, '--cache-read-only') == (0, '')
        assert files_of(models.folder / 'nginx/files') == []
        models.cook('--cache', address)
        assert models.cook('--cache', address, '--cache-read-only') == (models.count, '')
    with nginx(models.folder / 'nginx', '') as address:
        count, said = models.cook('--cache', address)
        assert count == models.count and said == '', said
    with nginx(empty(models.folder / 'other'), '') as address:
        count, said = models.cook('--cache', address)
        assert count == 0 and said.count('\n') == 1 and 'nothing is kept there: it answers 405 to PUT' in said, said


def absent(t):
    models = Models(t)
    began = time.monotonic()
    count, said = models.cook('--cache', f'http://127.0.0.1:{free_port()}')
    assert count == 0 and said.count('\n') == 1 and 'warning: ' in said, said
    # Nobody there answers at all: not even a refusal. RFC 5737 keeps the address for examples.
    local = empty(models.folder / 'local')
    models.cook('--cache', local)
    assert models.cook('--cache', local, '--cache', 'http://192.0.2.1')[0] == models.count
    return f'{time.monotonic() - began:.1f} s'


def slow(t):
    models = Models(t)

    def crawl(self):
        self.send_response(200)
        self.send_header('Content-Length', '1000000')
        self.end_headers()
        with contextlib.suppress(ConnectionError):
            for _ in range(100):
                self.wfile.write(b'x')
                self.wfile.flush()
                time.sleep(0.2)

    with liar(get=crawl) as (address, kind):
        began = time.monotonic()
        count, said = models.cook('--cache', address, '--cache-timeout', '1', '--jobs', '1')
        took = time.monotonic() - began
        assert count == 0 and 'it is not asked any more' in said, said
        assert kind.asked <= 3 + 4, f'{kind.asked}: three were waited for, and of two files what was cooked was put'
    return f'{took:.1f} s, asked {kind.asked} times'


def full(t):
    models = Models(t)
    with liar(put=lambda self, body: self.answer(507)) as (address, _):
        count, said = models.cook('--cache', address)
        assert count == 0 and said.count('\n') == 1 and 'nothing is kept there: it answers 507' in said, said
    with liar(put=lambda self, body: self.answer(500)) as (address, kind):
        count, said = models.cook('--cache', address, '--jobs', '1')
        assert count == 0 and 'it answers 500' in said, said
    broken = empty(models.folder / 'nginx')
    with nginx(broken, PUTS) as address:
        models.cook('--cache', address)
        # The disk is full after so many bytes: entries are cut, as by a server that does not rename.
        for name in files_of(broken / 'files')[::2]:
            os.truncate(broken / 'files' / name, 100)
        count, said = models.cook('--cache', address)
        assert count < models.count and 'gave other bytes' in said, (count, said)
        assert models.cook('--cache', address) == (models.count, ''), 'they have been replaced'


def lying(t):
    models = Models(t)

    def other(self):
        body = bytearray(self.kept.get(self.path, b'nothing'))
        body[len(body) // 2] ^= 1
        self.answer(200, bytes(body))

    def anothers(self):
        self.answer(200, next(iter(self.kept.values()), b''))

    def endless(self):
        self.send_response(200)
        self.send_header('Content-Length', str(1 << 40))
        self.end_headers()
        chunk = bytes(1 << 20)
        with contextlib.suppress(ConnectionError):
            while True:
                self.wfile.write(chunk)

    for way in (other, anothers, lambda self: self.answer(200, b''), lambda self: self.answer(302)):
        with liar() as (address, kind):
            models.cook('--cache', address)
            kind.get = way
            count, said = models.cook('--cache', address)
            assert count == 0, said
    with liar(get=endless) as (address, _):
        count, said = models.cook('--cache', address, '--jobs', '1')
        assert count == 0 and 'an entry of more than 256 MiB' in said, said


TESTS = [on_nginx, a_prefix_and_a_token, only_read, absent, slow, full, lying]
