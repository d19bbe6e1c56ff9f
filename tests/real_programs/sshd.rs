//! An SSH server for one test: its own keys and settings, on this machine only, as this user.

use std::io::Read;
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::work::{installed, search_path};

/// Far beyond what the server needs to listen.
const PATIENCE: Duration = Duration::from_secs(30);

/// The server, and the settings for its clients; it ends with the test.
pub(crate) struct Sshd {
    server: Child,
    /// For `ssh -F`; the host is called `there`.
    pub(crate) client: PathBuf,
}

impl Sshd {
    /// A server whose sessions have this directory as home.
    pub(crate) fn start(home: &Path) -> Self {
        let dir = home.join("ssh");
        std::fs::create_dir(&dir).unwrap();
        room_for_privilege_separation();
        for name in ["host", "user"] {
            let made = Command::new(installed("ssh-keygen"))
                .args(["-q", "-t", "ed25519", "-N", "", "-f"])
                .arg(dir.join(name))
                .status()
                .unwrap();
            assert!(made.success());
        }
        // Another process may take the free port before the server does.
        for _ in 0..5 {
            let port = free_port();
            settings(&dir, home, port);
            if let Some(server) = listening(&dir, port) {
                let client = dir.join("client");
                return Self { server, client };
            }
        }
        let log = std::fs::read_to_string(dir.join("log")).unwrap_or_default();
        panic!("sshd does not start:\n{log}");
    }

    /// The client with these words after the name of the host.
    pub(crate) fn ssh(&self, words: &str) -> Command {
        let mut ssh = Command::new(installed("ssh"));
        ssh.arg("-F").arg(&self.client).args(["there", words]);
        ssh.stdin(Stdio::null());
        ssh
    }
}

impl Drop for Sshd {
    fn drop(&mut self) {
        drop(self.server.kill());
        drop(self.server.wait());
    }
}

/// The server of the superuser insists on an empty directory, which a service manager would make.
fn room_for_privilege_separation() {
    if rustix::process::geteuid().is_root() {
        std::fs::create_dir_all("/run/sshd").unwrap();
    }
}

fn free_port() -> u16 {
    let listener = TcpListener::bind(("127.0.0.1", 0)).unwrap();
    listener.local_addr().unwrap().port()
}

fn settings(dir: &Path, home: &Path, port: u16) {
    let (dir_name, home) = (dir.display(), home.display());
    let path = search_path();
    let server = format!(
        "Port {port}\nListenAddress 127.0.0.1\nHostKey {dir_name}/host\nPidFile none\n\
         AuthorizedKeysFile {dir_name}/user.pub\nStrictModes no\nPermitRootLogin yes\n\
         PasswordAuthentication no\nKbdInteractiveAuthentication no\nUsePAM no\n\
         PrintMotd no\nPrintLastLog no\n\
         SetEnv HOME={home} LANG=C.UTF-8 PATH={path}\n"
    );
    std::fs::write(dir.join("server"), server).unwrap();
    let client = format!(
        "Host there\nHostName 127.0.0.1\nPort {port}\nIdentityFile {dir_name}/user\n\
         IdentitiesOnly yes\nIdentityAgent none\nBatchMode yes\nLogLevel ERROR\n\
         UserKnownHostsFile {dir_name}/known\nGlobalKnownHostsFile none\n\
         StrictHostKeyChecking yes\n"
    );
    std::fs::write(dir.join("client"), client).unwrap();
    let key = std::fs::read_to_string(dir.join("host.pub")).unwrap();
    std::fs::write(dir.join("known"), format!("[127.0.0.1]:{port} {key}")).unwrap();
}

/// The server once it greets; nothing when it ended instead.
fn listening(dir: &Path, port: u16) -> Option<Child> {
    let mut server = Command::new(installed("sshd"))
        .args(["-D", "-E"])
        .arg(dir.join("log"))
        .arg("-f")
        .arg(dir.join("server"))
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::inherit())
        .spawn()
        .unwrap();
    let end = Instant::now() + PATIENCE;
    while Instant::now() < end && server.try_wait().unwrap().is_none() {
        let mut greeting = [0_u8; 4];
        let greeted = TcpStream::connect(("127.0.0.1", port))
            .and_then(|mut stream| stream.read_exact(&mut greeting));
        if greeted.is_ok() && &greeting == b"SSH-" {
            return Some(server);
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    drop(server.kill());
    drop(server.wait());
    None
}
