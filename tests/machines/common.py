"""What the tests of many machines share: the program, models, folders that are the same, and servers."""
import contextlib
import filecmp
import http.server
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Skipped(Exception):
    """What the test needs is not there."""


def run(*command, code=0, **more):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, errors='replace', **more)
    assert done.returncode == code, f'{command}: exit code {done.returncode}, not {code}\n{done.stdout[-2000:]}{done.stderr[-2000:]}'
    return done


def make_models(folder, count, seed=1):
    run(sys.executable, ROOT / 'tools/farm/make_files.py', folder, count, seed)


def files_of(folder):
    return sorted(str(path.relative_to(folder)) for path in pathlib.Path(folder).rglob('*') if path.is_file())


def expect_same(one, other):
    names = files_of(one)
    assert names and names == files_of(other), f'{names[:5]} and {files_of(other)[:5]}'
    different = [name for name in names if not filecmp.cmp(pathlib.Path(one) / name, pathlib.Path(other) / name, shallow=False)]
    assert not different, different[:5]
    return len(names)


def empty(folder):
    shutil.rmtree(folder, ignore_errors=True)
    pathlib.Path(folder).mkdir(parents=True)
    return pathlib.Path(folder)


def free_port():
    with socket.socket() as s:
        s.bind(('127.0.0.1', 0))
        return s.getsockname()[1]


def needed(*names):
    for name in names:
        if shutil.which(name) is None:
            raise Skipped(f'there is no {name}')


def wait_for(what, seconds, why):
    until = time.monotonic() + seconds
    while not what():
        assert time.monotonic() < until, why
        time.sleep(0.05)


def answers(port):
    with contextlib.suppress(OSError), socket.create_connection(('127.0.0.1', port), 1):
        return True
    return False


@contextlib.contextmanager
def nginx(folder, locations):
    """A server of the folder below `files`, which takes PUT as nginx's ngx_http_dav_module does."""
    needed('nginx')
    folder, port = pathlib.Path(folder), free_port()
    (folder / 'files').mkdir(parents=True, exist_ok=True)
    (folder / 'nginx.conf').write_text(f'''
daemon off; worker_processes 1; pid {folder}/pid; error_log {folder}/error.txt;
{'user root;' if os.getuid() == 0 else ''}
events {{ worker_connections 256; }}
http {{
  access_log {folder}/access.txt; client_body_temp_path {folder}/body; client_max_body_size 0;
  proxy_temp_path {folder}/proxy; fastcgi_temp_path {folder}/fastcgi; uwsgi_temp_path {folder}/uwsgi;
  scgi_temp_path {folder}/scgi;
  server {{ listen 127.0.0.1:{port}; root {folder}/files; {locations} }}
}}''')
    server = subprocess.Popen(['nginx', '-c', folder / 'nginx.conf', '-e', folder / 'error.txt', '-p', folder])
    try:
        wait_for(lambda: answers(port), 10, 'nginx does not answer')
        yield f'http://127.0.0.1:{port}'
    finally:
        server.terminate()
        server.wait()


class Liar(http.server.BaseHTTPRequestHandler):
    """A server of the entries in `kept`; `get` and `put` say how it goes wrong."""
    kept, get, put, asked = {}, None, None, 0
    protocol_version = 'HTTP/1.1'

    def answer(self, status, body=b''):
        self.send_response(status)
        self.send_header('Content-Length', str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def do_GET(self):
        type(self).asked += 1
        if self.get:
            return self.get()
        body = self.kept.get(self.path)
        return self.answer(404) if body is None else self.answer(200, body)

    def do_PUT(self):
        type(self).asked += 1
        body = self.rfile.read(int(self.headers['Content-Length']))
        if self.put:
            return self.put(body)
        self.kept[self.path] = body
        return self.answer(201)

    def log_message(self, *_):
        pass


@contextlib.contextmanager
def liar(**ways):
    """Ways: get(self), put(self, body)."""
    kind = type('OneLiar', (Liar,), {'kept': {}, 'asked': 0, **ways})
    server = http.server.ThreadingHTTPServer(('127.0.0.1', 0), kind)
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f'http://127.0.0.1:{server.server_address[1]}', kind
    finally:
        server.shutdown()
        server.server_close()
