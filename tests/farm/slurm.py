"""A real Slurm on this machine alone: munged, slurmctld, and a slurmd for each node.

All that is started here, and all that it starts, are children of this process (a subreaper), and
are ended by their numbers.
"""

import ctypes
import os
import pathlib
import secrets
import signal
import socket
import subprocess
import time

CONFIGURATION = """\
ClusterName=specbake
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/run/munge.sock
CredType=cred/munge
SlurmctldPort={port}
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/run/slurmctld.pid
SlurmdPidFile={folder}/run/slurmd.%n.pid
SlurmctldLogFile={folder}/log/slurmctld.log
SlurmdLogFile={folder}/log/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
PlugStackConfig=/dev/null
SlurmdTimeout=6
MessageTimeout=2
TCPTimeout=1
KillWait=5
SchedulerParameters=sched_interval=1,batch_sched_delay=0
"""
NODE = "NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs=1 State=UNKNOWN\n"
PARTITION = "PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n"
SET_CHILD_SUBREAPER = 36  # prctl(2)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def processes():
    """The number and the parent's number of each."""
    for folder in pathlib.Path("/proc").iterdir():
        if not folder.name.isdigit():
            continue
        try:
            status = (folder / "stat").read_text()
        except OSError:
            continue
        yield int(folder.name), int(status.rpartition(")")[2].split()[1])


def descendants(ancestor):
    children = {}
    for process, parent in processes():
        children.setdefault(parent, []).append(process)
    found, pending = [], [ancestor]
    while pending:
        for child in children.get(pending.pop(), []):
            found.append(child)
            pending.append(child)
    return found


def text_of(process, name):
    try:
        return pathlib.Path(f"/proc/{process}/{name}").read_bytes().decode(errors="replace")
    except OSError:
        return ""


def kill(processes_, number):
    for process in processes_:
        try:
            os.kill(process, number)
        except ProcessLookupError:
            pass


class Slurm:
    """With a node for each name, of one processor each."""

    def __init__(self, folder, nodes):
        self.folder = pathlib.Path(folder)
        self.nodes = nodes
        self.host = socket.gethostname().partition(".")[0]

    def __enter__(self):
        ctypes.CDLL(None).prctl(SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        for name in ["run", "log", "state", *(f"spool.{node}" for node in self.nodes)]:
            (self.folder / name).mkdir(parents=True)
        key = self.folder / "munge.key"
        key.write_bytes(secrets.token_bytes(1024))
        key.chmod(0o400)
        user = subprocess.run(["id", "-un"], stdout=subprocess.PIPE, text=True, check=True).stdout
        values = {"folder": self.folder, "host": self.host, "user": user.strip()}
        text = CONFIGURATION.format(port=free_port(), **values)
        for node in self.nodes:
            text += NODE.format(name=node, host=self.host, port=free_port())
        self.configuration = self.folder / "slurm.conf"
        self.configuration.write_text(text + PARTITION)
        os.environ["SLURM_CONF"] = str(self.configuration)
        try:
            self.start()
        except BaseException:
            self.__exit__()
            raise
        return self

    def start(self):
        run, log = self.folder / "run", self.folder / "log"
        self.call("munged", f"--key-file={self.folder}/munge.key", f"--socket={run}/munge.sock",
                  f"--pid-file={run}/munged.pid", f"--log-file={log}/munged.log",
                  f"--seed-file={run}/munged.seed", "--force")
        self.call("slurmctld", "-f", str(self.configuration))
        for node in self.nodes:
            self.start_node(node)
        self.wait(lambda: self.states() == {node: "idle" for node in self.nodes}, 60,
                  "the nodes are idle")

    def start_node(self, node):
        self.call("slurmd", "-N", node, "-f", str(self.configuration))

    def __exit__(self, *_):
        """Ends what is left of it, and waits for that."""
        for number in (signal.SIGTERM, signal.SIGKILL):
            kill(descendants(os.getpid()), number)
            deadline = time.monotonic() + 5
            while time.monotonic() < deadline and self.reap():
                time.sleep(0.02)

    @staticmethod
    def reap():
        """Whether there are children left."""
        try:
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            return False
        return True

    @staticmethod
    def call(*words):
        done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode:
            raise RuntimeError(f"{' '.join(words)}: {done.stdout}")
        return done.stdout

    @staticmethod
    def wait(condition, seconds, what):
        deadline = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > deadline:
                raise TimeoutError(f"{seconds} s, and still not so: {what}")
            time.sleep(0.05)

    def states(self):
        lines = self.call("sinfo", "-h", "-N", "-o", "%N %T").splitlines()
        return dict(line.split() for line in lines)

    def tasks(self, job):
        """The state and the node of each task that is not over; of a job that is no array, of 0."""
        lines = self.call("squeue", "-h", "-r", "-j", job, "-o", "%K|%T|%N").splitlines()
        words = [line.split("|") for line in lines]
        return {int(task) if task.isdigit() else 0: (state, node) for task, state, node in words}

    def requeue(self, job, task):
        """Ends a task, and has it begin anew."""
        self.call("scontrol", "requeue", f"{job}_{task}")

    def hasten(self, job):
        """Tasks that were requeued wait for two minutes by themselves."""
        for task, (state, _) in self.tasks(job).items():
            if state == "PENDING":
                subprocess.run(["scontrol", "update", f"JobId={job}_{task}", "StartTime=now"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def lose(self, node):
        """As if the machine's power failed: all that runs on it ends at once, and says nothing."""
        lost = set()
        for process, parent in processes():
            if f"SLURMD_NODENAME={node}\0" in text_of(process, "environ"):
                lost.update([process, *descendants(process)])
                if text_of(parent, "cmdline").startswith("slurmstepd"):
                    lost.add(parent)
            elif text_of(process, "cmdline").split("\0")[:3] == ["slurmd", "-N", node]:
                lost.add(process)
        lost.intersection_update(descendants(os.getpid()))
        for number in (signal.SIGSTOP, signal.SIGKILL):
            kill(lost, number)
