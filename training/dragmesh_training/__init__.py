"""Training of dragmesh's two networks: KPP-Net and DQ-VAE (docs/networks.md)."""
