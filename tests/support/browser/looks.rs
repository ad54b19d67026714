//! What is seen of a page: its size and media, pictures of it, paper, saved files.

use super::{Browser, wait};
use crate::files;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Value, json};

impl Browser {
    /// Shows the page on a screen of that many pixels that is touched with fingers.
    pub fn telephone(&mut self, [width, height]: [u32; 2]) {
        let metrics = json!({ "width": width, "height": height, "deviceScaleFactor": 2, "mobile": true });
        self.call("Emulation.setDeviceMetricsOverride", metrics);
        self.call("Emulation.setTouchEmulationEnabled", json!({ "enabled": true, "maxTouchPoints": 5 }));
    }

    /// Shows the page on a screen of that many pixels of a page's, each of so many of the screen's.
    pub fn screen(&mut self, [width, height]: [u32; 2], scale: f64) {
        let metrics = json!({ "width": width, "height": height, "deviceScaleFactor": scale, "mobile": false });
        self.call("Emulation.setDeviceMetricsOverride", metrics);
    }

    /// Has the page believe in what a person prefers, as `[("prefers-color-scheme", "dark")]`, or in `print`.
    pub fn media(&mut self, media: &str, features: &[(&str, &str)]) {
        let features: Vec<Value> =
            features.iter().map(|(name, value)| json!({ "name": name, "value": value })).collect();
        self.call("Emulation.setEmulatedMedia", json!({ "media": media, "features": features }));
    }

    /// Leaves a picture of the page as `target/pictures/NAME.png`, where `KINEGON_PICTURES` is set.
    pub fn picture(&mut self, name: &str) {
        if std::env::var_os("KINEGON_PICTURES").is_none() {
            return;
        }
        let folder = files::built().with_file_name("pictures");
        std::fs::create_dir_all(&folder).expect("the test's folder can be written");
        std::fs::write(folder.join(format!("{name}.png")), self.shot()).expect("written");
    }

    /// What is seen of the page, as PNG.
    pub fn shot(&mut self) -> Vec<u8> {
        let shot = self.call("Page.captureScreenshot", json!({ "format": "png" }));
        bytes(&shot["data"])
    }

    /// The page on paper, as PDF, in the size that it asks for itself.
    pub fn printed(&mut self) -> Vec<u8> {
        let how = json!({ "preferCSSPageSize": true, "printBackground": true });
        let printed = self.call("Page.printToPDF", how);
        bytes(&printed["data"])
    }

    /// The file that is saved while `act` is done: its name and bytes.
    pub fn saved(&mut self, act: impl FnOnce(&mut Browser)) -> (String, Vec<u8>) {
        let folder = self.folder.join("saved");
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).expect("the test's folder can be written");
        let session = std::mem::take(&mut self.session);
        let behavior = json!({ "behavior": "allow", "downloadPath": folder, "browserContextId": self.context });
        self.call("Browser.setDownloadBehavior", behavior);
        self.session = session;
        act(self);
        wait("a saved file", || {
            // Keeps listening.
            self.value("1");
            let path = std::fs::read_dir(&folder).ok()?.flatten().next()?.path();
            let name = path.file_name()?.to_str()?.to_owned();
            let is_whole = !name.ends_with(".crdownload") && !name.starts_with('.');
            let bytes = std::fs::read(&path).ok().filter(|bytes| is_whole && !bytes.is_empty())?;
            Some((name, bytes))
        })
    }
}

fn bytes(letters: &Value) -> Vec<u8> {
    BASE64_STANDARD.decode(letters.as_str().expect("base64")).expect("base64")
}
