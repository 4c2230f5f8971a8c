"""A cluster of one node on this machine: munged, slurmctld and slurmd, as Debian has them."""
import contextlib
import json
import os
import pathlib
import socket
import subprocess
import time

from common import Skipped, empty, expect_same, files_of, free_port, make_models, needed, run, wait_for


class Cluster:
    """Its state outlives the daemons, so they can be started anew."""

    def __init__(self, folder, cpus=2):
        needed('slurmctld', 'slurmd', 'sbatch', 'munged')
        if os.getuid() != 0:
            raise Skipped('slurmd needs root')
        self.folder = empty(folder)
        self.daemons = []
        os.chmod(self.folder, 0o755)
        for name in ('state', 'spool', 'munge'):
            (self.folder / name).mkdir(mode=0o755)
        key = self.folder / 'munge/key'
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self.munge_socket = self.folder / 'munge/socket'
        host, control, node = socket.gethostname().split('.')[0], free_port(), free_port()
        memory = os.sysconf('SC_PHYS_PAGES') * os.sysconf('SC_PAGE_SIZE') // 2**20 * 3 // 4
        self.configuration = self.folder / 'slurm.conf'
        self.configuration.write_text(f'''
ClusterName=marrow
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={control}
SlurmdPort={node}
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={self.munge_socket}
CryptoType=crypto/munge
StateSaveLocation={self.folder}/state
SlurmdSpoolDir={self.folder}/spool
SlurmctldPidFile={self.folder}/slurmctld.pid
SlurmdPidFile={self.folder}/slurmd.pid
SlurmctldLogFile={self.folder}/slurmctld.txt
SlurmdLogFile={self.folder}/slurmd.txt
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SchedulerType=sched/backfill
SchedulerParameters=bf_interval=1,sched_min_interval=0,batch_sched_delay=0
MpiDefault=none
ReturnToService=2
MinJobAge=300
KillWait=1
JobRequeue=1
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory={memory} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
''')

    def environment(self):
        return {**os.environ, 'SLURM_CONF': str(self.configuration)}

    def start(self, *command):
        daemon = subprocess.Popen([str(part) for part in command], env=self.environment(), stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL, start_new_session=True)
        self.daemons.append(daemon)
        return daemon

    def start_control(self):
        self.control = self.start('slurmctld', '-D')
        wait_for(lambda: self.ask('scontrol', 'ping', fails=True).stdout.find('UP') >= 0, 20, 'slurmctld does not answer')

    def __enter__(self):
        munge = self.folder / 'munge'
        self.start('munged', '-F', '--force', f'--key-file={munge}/key', f'--socket={self.munge_socket}',
                   f'--log-file={munge}/log', f'--pid-file={munge}/pid', f'--seed-file={munge}/seed')
        wait_for(self.munge_socket.exists, 10, 'munged does not come up')
        self.start_control()
        self.start('slurmd', '-D')
        wait_for(lambda: 'idle' in self.ask('sinfo', '-h', '-o', '%t').stdout, 30, 'the node does not come up')
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            with contextlib.suppress(ProcessLookupError):
                os.killpg(daemon.pid, 9)
            daemon.wait()

    def ask(self, *command, fails=False):
        done = subprocess.run(command, env=self.environment(), capture_output=True, text=True, check=False)
        assert fails or done.returncode == 0, f'{command}: {done.stderr}'
        return done

    def states(self):
        return self.ask('squeue', '-h', '-r', '-o', '%j %t %i', fails=True).stdout.split('\n')[:-1]

    def wait(self, last, seconds=240):
        def ended():
            said = self.ask('scontrol', 'show', 'job', last, fails=True).stdout
            return 'JobState=COMPLETED' in said or 'JobState=FAILED' in said
        wait_for(ended, seconds, f'job {last} does not end: {self.states()}')

    def submit(self, t, shards, folder, *arguments, **more):
        done = run(t.root / 'tools/farm/slurm.sh', shards, folder, *arguments,
                   env={**self.environment(), 'MARROW': str(t.marrow), **more})
        return done.stdout.strip()


def an_array_of_shards(t):
    with Cluster(t.work / 'slurm') as cluster:
        folder = cluster.folder
        make_models(folder / 'in', 24)
        run(t.marrow, 'cook', folder / 'in', '-o', folder / 'want')
        cook = (folder / 'in', '-o', folder / 'out', '--cache', folder / 'cache')
        cluster.wait(cluster.submit(t, 4, folder / 'farm', *cook))
        expect_same(folder / 'want', folder / 'out')
        merged = json.loads((folder / 'farm/report.json').read_text())
        assert len(merged) == 24 and (folder / 'farm/report.html').exists()
        # Again: all from the cache, with what the first has learnt of times, and one file that cannot be cooked, with a name
        # that shells would take apart.
        (folder / "in/it's $bad.glb").write_bytes(b'glTF')
        cluster.wait(cluster.submit(t, 4, folder / 'farm', *cook))
        plan = json.loads((folder / 'farm/plan.json').read_text())
        assert sum(unit['seconds_from'] == 'history' for unit in plan['units']) == 24
        said = (folder / 'farm/merge.txt').read_text()
        assert "it's $bad.glb: " in said and '25 files, 1 failed, 24 from the cache; ' in said, said
        again = [name for name in files_of(folder / 'farm') if name.startswith('again-')]
        tried = sum('files:' in (folder / 'farm' / name).read_text() for name in again)
        assert tried == 1, 'the share with the failure alone is tried once more'
    return '24 files in 4 shares'


def killed_and_restarted(t):
    """Workers die and the scheduler restarts in the middle; in the end all is there."""
    with Cluster(t.work / 'slurm-faults') as cluster:
        folder = cluster.folder
        make_models(folder / 'in', 60)
        run(t.marrow, 'cook', folder / 'in', '-o', folder / 'want')
        last = cluster.submit(t, 6, folder / 'farm', folder / 'in', '-o', folder / 'out', '--cache', folder / 'cache')
        wait_for(lambda: any(' R ' in state for state in cluster.states()), 30, 'nothing runs')
        time.sleep(0.3)
        killed = subprocess.run(['pkill', '-KILL', '-f', f'^{t.marrow} cook {folder}/in'], check=False).returncode == 0
        cluster.control.terminate()  # as a restart does: it saves its state, which it does every 5 s besides
        cluster.control.wait()
        time.sleep(1)
        cluster.start_control()
        cluster.wait(last)
        for name in files_of(folder / 'out'):
            if pathlib.Path(name).name.startswith('.'):
                os.remove(folder / 'out' / name)
        expect_same(folder / 'want', folder / 'out')
        said = (folder / 'farm/merge.txt').read_text()
        assert '60 files, 0 failed' in said, said
    return f'60 files in 6 shares, workers {"killed" if killed else "not caught"}, slurmctld started anew'


TESTS = [an_array_of_shards, killed_and_restarted]
