//! Images on their way to tev, a viewer for linear HDR that other programs can send images to.

use crate::domain::image::HdrImage;
use std::{
    io,
    net::{TcpStream, ToSocketAddrs as _},
    time::Duration,
};
use tev_client::{PacketCreateImage, PacketUpdateImage, TevClient};

/// A running tev.
#[derive(Debug)]
pub struct Tev {
    client: TevClient,
    address: String,
}

/// How long tev may take to answer.
const PATIENCE: Duration = Duration::from_secs(5);

impl Tev {
    /// Where tev listens if it is not told otherwise.
    pub const ADDRESS: &'static str = "localhost:14158";

    /// Connects to a tev at `host:port`.
    ///
    /// # Errors
    /// [`TevError::Connect`] if there is none.
    pub fn connect(address: &str) -> Result<Self, TevError> {
        let connect = || -> io::Result<TcpStream> {
            let mut failure = io::Error::from(io::ErrorKind::AddrNotAvailable);
            for place in address.to_socket_addrs()? {
                match TcpStream::connect_timeout(&place, PATIENCE) {
                    Ok(stream) => return Ok(stream),
                    Err(e) => failure = e,
                }
            }
            Err(failure)
        };
        match connect() {
            Ok(stream) => Ok(Self {
                client: TevClient::wrap(stream),
                address: address.into(),
            }),
            Err(source) => Err(TevError::Connect {
                address: address.into(),
                source,
            }),
        }
    }

    /// Shows an image under a name, in the place of any that has this name. An image without pixels is
    /// left out.
    ///
    /// # Errors
    /// [`TevError::Send`] if tev went away.
    pub fn show(&mut self, name: &str, image: &HdrImage) -> Result<(), TevError> {
        if image.pixels.is_empty() {
            return Ok(());
        }
        let name = name.replace('\0', " ");
        let channel_names = &["R", "G", "B"];
        let (width, height) = (image.width as u32, image.height as u32);
        let data: Vec<f32> = image.pixels.iter().flat_map(|p| p.to_array()).collect();
        let created = self.client.send(PacketCreateImage {
            image_name: &name,
            grab_focus: false,
            width,
            height,
            channel_names,
        });
        let sent = created.and_then(|()| {
            self.client.send(PacketUpdateImage {
                image_name: &name,
                grab_focus: false,
                channel_names,
                channel_offsets: &[0, 1, 2],
                channel_strides: &[3, 3, 3],
                x: 0,
                y: 0,
                width,
                height,
                data: &data,
            })
        });
        sent.map_err(|source| TevError::Send {
            address: self.address.clone(),
            source,
        })
    }
}

/// Why images can't be shown in tev.
#[derive(Debug, thiserror::Error)]
pub enum TevError {
    /// Nothing listens there.
    #[error("no tev at {address}: {source}; start tev, or name its --tev=HOST:PORT")]
    Connect {
        /// Host and port.
        address: String,
        /// What the system said.
        source: io::Error,
    },
    /// The connection broke.
    #[error("tev at {address} accepts no more images: {source}")]
    Send {
        /// Host and port.
        address: String,
        /// What the system said.
        source: io::Error,
    },
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]
    use super::*;
    use glam::Vec3;
    use std::{io::Read as _, net::TcpListener, thread};

    /// Takes the first bytes off and gives them as a number.
    fn number<const N: usize>(bytes: &mut &[u8]) -> u64 {
        let (head, rest) = bytes.split_at(N);
        *bytes = rest;
        head.iter().rev().fold(0, |n, b| n << 8 | u64::from(*b))
    }

    fn text(bytes: &mut &[u8]) -> String {
        let end = bytes.iter().position(|b| *b == 0).unwrap();
        let (head, rest) = bytes.split_at(end);
        *bytes = &rest[1..];
        String::from_utf8(head.to_vec()).unwrap()
    }

    #[test]
    fn an_image_is_made_and_then_filled() {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap().to_string();
        let received = thread::spawn(move || {
            let mut bytes = Vec::new();
            listener
                .accept()
                .unwrap()
                .0
                .read_to_end(&mut bytes)
                .unwrap();
            bytes
        });
        let mut image = HdrImage::new(2, 1);
        image.set(1, 0, Vec3::new(0.5, -1.0, 1e6));
        let mut tev = Tev::connect(&address).unwrap();
        tev.show("box/irradiance/truth", &image).unwrap();
        tev.show("nothing", &HdrImage::new(0, 0)).unwrap();
        drop(tev);
        let received = received.join().unwrap();

        let mut rest = received.as_slice();
        let create_length = number::<4>(&mut rest) as usize;
        assert_eq!(number::<1>(&mut rest), 4, "create");
        assert_eq!(number::<1>(&mut rest), 0, "takes no focus");
        assert_eq!(text(&mut rest), "box/irradiance/truth");
        let [w, h, n] = std::array::from_fn(|_| number::<4>(&mut rest));
        assert_eq!((w, h, n), (2, 1, 3));
        assert_eq!([(); 3].map(|()| text(&mut rest)), ["R", "G", "B"]);
        assert_eq!(received.len() - rest.len(), create_length);

        let update_length = number::<4>(&mut rest) as usize;
        assert_eq!(create_length + update_length, received.len());
        assert_eq!(number::<1>(&mut rest), 6, "update");
        assert_eq!(number::<1>(&mut rest), 0, "takes no focus");
        assert_eq!(text(&mut rest), "box/irradiance/truth");
        assert_eq!(number::<4>(&mut rest), 3);
        assert_eq!([(); 3].map(|()| text(&mut rest)), ["R", "G", "B"]);
        let window: [u64; 4] = std::array::from_fn(|_| number::<4>(&mut rest));
        assert_eq!(window, [0, 0, 2, 1]);
        let layout: [u64; 6] = std::array::from_fn(|_| number::<8>(&mut rest));
        assert_eq!(layout, [0, 1, 2, 3, 3, 3]);
        let data: [f32; 6] = std::array::from_fn(|_| f32::from_bits(number::<4>(&mut rest) as u32));
        assert_eq!(data, [0.0, 0.0, 0.0, 0.5, -1.0, 1e6]);
        assert!(rest.is_empty());
    }

    #[test]
    fn no_tev_is_one_line_with_a_remedy() {
        // Nothing can listen there.
        let address = "127.0.0.1:0";
        let message = Tev::connect(address).unwrap_err().to_string();
        assert!(
            message.contains(address) && message.contains("--tev"),
            "{message}"
        );
        assert!(!message.contains('\n'));
    }
}
